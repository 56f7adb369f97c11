//! PNGs, decoded.

/// A decoded PNG.
pub(crate) struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) per_metre: u32,
    /// Red, green and blue of all pixels, row by row.
    pub(crate) colours: Vec<u8>,
}

impl Picture {
    pub(crate) fn read(png: &[u8]) -> Picture {
        let mut reader = png::Decoder::new(png).read_info().expect("a PNG");
        let mut colours = vec![0; reader.output_buffer_size()];
        let frame = reader.next_frame(&mut colours).expect("a frame");
        let per_metre = reader.info().pixel_dims.expect("a resolution").xppu;
        Picture { width: frame.width, height: frame.height, per_metre, colours }
    }

    /// Red, green and blue of a pixel.
    pub(crate) fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let start = 3 * (y * self.width as usize + x);
        [self.colours[start], self.colours[start + 1], self.colours[start + 2]]
    }
}
