package nephele.engine.render.pass.sky;

import java.nio.ByteBuffer;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.SkyboxPictures;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import org.joml.Vector3d;
import org.lwjgl.system.MemoryUtil;

/**
 * The faces as layers, each with a border of one texel from its neighbours: bilinear samples cross the cube's edges
 * without a seam. A flat texture is used because cube textures cost llvmpipe more.
 */
final class SkyboxTexture {
    private static final int BYTES = 4;

    private SkyboxTexture() {}

    static Texture upload(LoadContext context, SkyboxPictures faces) {
        int side = faces.side() + 2;
        PixelFormat format = context.output().pictures();
        Texture.Extent extent = new Texture.Extent(side, side, 6);
        Texture texture =
                new Texture(context.gl(), "skybox", Texture.Shape.ARRAY, format, extent, Sampling.LINEAR_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(BYTES * side * side);
        for (int face = 0; face < 6; face++) {
            texels.clear();
            fill(texels, faces, face);
            texture.upload(face, texels.flip());
        }
        MemoryUtil.memFree(texels);
        return texture;
    }

    private static void fill(ByteBuffer texels, SkyboxPictures faces, int face) {
        int side = faces.side();
        byte[] own = faces.pictures().get(face).samples();
        for (int y = -1; y <= side; y++) {
            if (y < 0 || y >= side) {
                putCorner(texels, faces, face, -1, y);
                for (int x = 0; x < side; x++) {
                    putFromNeighbour(texels, faces, face, x, y);
                }
                putCorner(texels, faces, face, side, y);
            } else {
                putFromNeighbour(texels, faces, face, -1, y);
                texels.put(own, BYTES * y * side, BYTES * side);
                putFromNeighbour(texels, faces, face, side, y);
            }
        }
    }

    private static void putFromNeighbour(ByteBuffer texels, SkyboxPictures faces, int face, int x, int y) {
        int side = faces.side();
        Vector3d point = SkyboxCube.point(face, (2.0 * x + 1) / side - 1, (2.0 * y + 1) / side - 1);
        int neighbour = SkyboxCube.faceOf(point);
        Picture picture = faces.pictures().get(neighbour);
        int nx = texel(SkyboxCube.right(point, neighbour), side);
        int ny = texel(SkyboxCube.down(point, neighbour), side);
        texels.put(picture.samples(), BYTES * (ny * side + nx), BYTES);
    }

    /** Puts the mean of the three texels at a corner of the cube, so that its three faces interpolate to one value. */
    private static void putCorner(ByteBuffer texels, SkyboxPictures faces, int face, int x, int y) {
        int side = faces.side();
        int onX = Math.max(0, Math.min(side - 1, x));
        int onY = Math.max(0, Math.min(side - 1, y));
        ByteBuffer three = ByteBuffer.allocate(3 * BYTES);
        putFromNeighbour(three, faces, face, onX, onY);
        putFromNeighbour(three, faces, face, x, onY);
        putFromNeighbour(three, faces, face, onX, y);
        for (int i = 0; i < BYTES; i++) {
            int sum = (three.get(i) & 0xff) + (three.get(BYTES + i) & 0xff) + (three.get(2 * BYTES + i) & 0xff);
            texels.put((byte) ((2 * sum + 3) / 6));
        }
    }

    private static int texel(double coordinate, int side) {
        return Math.min(side - 1, Math.max(0, (int) ((coordinate + 1) / 2 * side)));
    }
}
