"""The production path under the name of this package: what computes the torque that `fembearing` checks."""

from analytic.function import torque_function as torque_function
from analytic.prediction.prediction import predict as predict
from analytic.scene_torque import SceneTorque as SceneTorque
from analytic.scene_torque import torque_of_scene as torque_of_scene
from analytic.scenefile.read import load_scene as load_scene
from analytic.torque import friction_torque as friction_torque
