"""Films of results."""

from __future__ import annotations

from collections.abc import Iterable
from io import BytesIO

import numpy as np
from numpy.typing import NDArray

from softcat_sym.tracking.film import pyav


def mp4(pictures: Iterable[NDArray[np.uint8]], rate: int) -> bytes:
    """Pictures of one size, shape (rows, columns, 3), as a film that every player shows: H.264, so many a second.

    Rows and columns are even in such a film; an odd one at the edge is left out.
    """
    av, stream = pyav(), BytesIO()
    with av.open(stream, "w", format="mp4") as container:
        codec = "libx264" if "libx264" in av.codecs_available else "mpeg4"
        video = container.add_stream(codec, rate=rate, options={"crf": "20"})
        for picture in pictures:
            rows, columns = (size - size % 2 for size in picture.shape[:2])
            if not video.codec_context.is_open:
                video.height, video.width, video.pix_fmt = rows, columns, "yuv420p"
            frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture[:rows, :columns]), format="rgb24")
            container.mux(video.encode(frame))
        container.mux(video.encode(None))
    return stream.getvalue()
