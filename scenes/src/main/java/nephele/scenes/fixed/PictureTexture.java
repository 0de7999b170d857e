package nephele.scenes.fixed;

import java.nio.ByteBuffer;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.Texture.Extent;
import nephele.engine.render.gl.Texture.Shape;
import org.lwjgl.BufferUtils;

/** Makes textures of pictures, with the stored values and (0, 0) at the bottom-left corner. */
final class PictureTexture {
    private PictureTexture() {}

    static Texture of(GlContext gl, String name, Picture picture) {
        Picture rgba = picture.toRgba8();
        int rowBytes = 4 * rgba.width();
        ByteBuffer upwards = BufferUtils.createByteBuffer(rowBytes * rgba.height());
        for (int row = rgba.height() - 1; row >= 0; row--) {
            upwards.put(rgba.samples(), row * rowBytes, rowBytes);
        }
        Texture texture = new Texture(
                gl,
                name,
                Shape.FLAT,
                PixelFormat.RGBA8,
                Extent.flat(rgba.width(), rgba.height()),
                Sampling.MIPMAPPED_REPEAT);
        texture.upload(0, upwards.flip());
        texture.generateLevels();
        return texture;
    }

    /** Returns a texture that leaves a colour unchanged when multiplied. */
    static Texture white(GlContext gl) {
        byte full = (byte) 0xff;
        return of(gl, "white", new Picture(1, 1, 4, 8, new byte[] {full, full, full, full}));
    }
}
