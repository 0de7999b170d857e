package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.render.gl.Texture.Extent;
import nephele.engine.render.gl.Texture.Shape;
import org.junit.jupiter.api.Test;

/** The context knows the storage of its textures. */
class TextureBytesGlTest {
    @Test
    void texelsCountUntilTheTextureIsClosed() {
        try (GlContext gl = GlContext.offscreen()) {
            long before = gl.live().textureBytes();
            Extent extent = new Extent(5, 3, 7);
            var volume = new Texture(gl, "volume", Shape.VOLUME, PixelFormat.RGBA16F, extent, Sampling.LINEAR_CLAMP);
            assertEquals(before + 8 * 5 * 3 * 7, gl.live().textureBytes());
            volume.close();
            assertEquals(before, gl.live().textureBytes());
        }
    }
}
