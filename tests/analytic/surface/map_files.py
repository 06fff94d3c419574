"""A rough surface, its form by another method than ours, and files as instruments write them."""

import struct
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np

SPACING = 1.7e-6  # m
ROUGH = 1e-7 * np.random.default_rng(11).standard_normal((40, 53))
INDEX = """<?xml version="1.0" encoding="UTF-8"?>{doctype}
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
<Record1><Revision>ISO5436 \u2013 2000</Revision><FeatureType>{feature}</FeatureType><Axes>
<CX><AxisType>{axis}</AxisType><DataType>D</DataType><Increment>{x}</Increment><Offset>0</Offset></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{y}</Increment><Offset>0</Offset></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType><Increment>{z}</Increment><Offset>0</Offset></CZ>
</Axes></Record1>
<Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>{layers}</SizeZ></MatrixDimension>
{data}</Record3></p:ISO5436_2>
"""
LINKS = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>{}</DataLink>"
VALID = "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
USUAL = {"doctype": "", "feature": "SUR", "axis": "I", "x": SPACING, "y": SPACING, "z": 1.0, "kind": "D", "layers": 1}


def formless(heights: np.ndarray) -> np.ndarray:
    """Without the polynomial of second order."""
    y, x = (place.ravel() for place in np.mgrid[: heights.shape[0], : heights.shape[1]])
    terms = np.column_stack([np.ones(x.size), x, y, x * x, x * y, y * y]).astype(float)
    return heights - (terms @ np.linalg.lstsq(terms, heights.ravel())[0]).reshape(heights.shape)


def x3p(
    file: Path, heights: np.ndarray, *, folder: str = "", valid: np.ndarray | None = None, listed: bool = False, **said
) -> Path:
    """valid : points in the file of valid points;  listed : heights in main.xml itself;  said : of `USUAL`"""
    said = USUAL | dict(zip(("rows", "columns"), heights.shape, strict=True)) | said
    points = "".join(f"<Datum>;;{'' if np.isnan(each) else repr(float(each))}</Datum>" for each in heights.flat)
    data = f"<DataList>{points}</DataList>" if listed else LINKS.format("" if valid is None else VALID)
    with ZipFile(file, "w", ZIP_DEFLATED) as archive:
        archive.writestr(f"{folder}main.xml", INDEX.format(data=data, **said))
        types = {"D": "<f8", "F": "<f4", "L": "<i4", "I": "<i2"}
        archive.writestr(f"{folder}bindata/data.bin", heights.astype(types.get(said["kind"], "<f8")).tobytes())
        if valid is not None:
            archive.writestr(f"{folder}bindata/valid.bin", np.packbits(valid, bitorder="little").tobytes())
    return file


def sur(file: Path, steps: np.ndarray, *, unit: bytes = b"\xb5m", spacing: float = 1e6 * SPACING) -> Path:
    """Digital Surf's, with steps of a ten-thousandth of the unit."""
    rows, columns = steps.shape
    head = struct.pack("<12s4H30s30s5H8xH", b"DIGITAL SURF", 0, 1, 1, 2, b"race", b"", 0, 0, 0, 0, 1, 32)
    head += struct.pack("<iiiiI", int(steps.min()), int(steps.max()), columns, rows, rows * columns)
    head += struct.pack("<fff", spacing, spacing, 1e-4)
    head += b"".join(word.ljust(16) for word in (b"X", b"Y", b"Z", *6 * [unit]))
    head += struct.pack("<fff3H12x6HHf8x2x2H128s3f34x", 1, 1, 1, 0, 0, 0, 1, 2, 3, 4, 5, 2024, 0, 0, 0, 0, b"", 0, 0, 0)
    file.write_bytes(head + steps.astype("<i4").tobytes())
    return file


def plu(file: Path, *layers: np.ndarray) -> Path:
    """Sensofar's, with heights in um."""
    rows, columns = layers[0].shape
    head = struct.pack("<128sI256s", b"Tue Apr 02 10:11:12 2024", 0, b"")
    head += struct.pack("<III7f", rows, columns, 0, 1, 1e6 * SPACING, 1e6 * SPACING, 0, 0, 1, 0)
    head += struct.pack("<5I", 3, 0, 0, 0, 1) + struct.pack("<5IdfII", 0, 0, columns, rows, 0, 0, 0, 0, 0)
    head += struct.pack("<5B3xI", 0, len(layers), 0, 0, 0, 0)
    numbers = [struct.pack("<II", *each.shape) + (1e6 * each).astype("<f4").tobytes() + bytes(8) for each in layers]
    file.write_bytes(head + b"".join(numbers))
    return file


def opd(file: Path, heights: np.ndarray) -> Path:
    """Wyko's, with heights in wavelengths of 632.8 nm, and x first."""
    columns_first = heights[::-1].T / 632.8e-9
    raster = struct.pack("<HHH", *columns_first.shape, 4) + columns_first.astype("<f4").tobytes()
    numbers = [(b"RAW_DATA", 3, raster), (b"Wavelength", 7, struct.pack("<f", 632.8))]
    numbers += [(b"Mult", 6, struct.pack("<h", 1)), (b"Pixel_size", 7, struct.pack("<f", 1e3 * SPACING))]
    blocks = [struct.pack("<16shlH", name, kind, len(part), 0) for name, kind, part in numbers]
    directory = struct.pack("<16shlH", b"Directory", 1, 24 * (len(blocks) + 1), 0)
    file.write_bytes(b"\1\0" + directory + b"".join(blocks) + b"".join(part for _, _, part in numbers))
    return file
