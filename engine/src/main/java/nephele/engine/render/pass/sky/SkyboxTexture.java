package nephele.engine.render.pass.sky;

import java.nio.ByteBuffer;
import nephele.engine.asset.Picture;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Output;
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
    private SkyboxTexture() {}

    static Texture upload(LoadContext context, SkyboxLayers faces) {
        int side = faces.side() + 2;
        PixelFormat format = context.output() == Output.PLAIN ? PixelFormat.RGBA8 : PixelFormat.SRGB8_ALPHA8;
        Texture.Extent extent = new Texture.Extent(side, side, 6);
        Texture texture =
                new Texture(context.gl(), "skybox", Texture.Shape.ARRAY, format, extent, Sampling.LINEAR_CLAMP);
        ByteBuffer texels = MemoryUtil.memAlloc(4 * side * side);
        for (int face = 0; face < 6; face++) {
            texels.clear();
            fill(texels, faces, face);
            texture.upload(face, texels.flip());
        }
        MemoryUtil.memFree(texels);
        return texture;
    }

    private static void fill(ByteBuffer texels, SkyboxLayers faces, int face) {
        int side = faces.side();
        byte[] own = faces.pictures().get(face).samples();
        for (int y = -1; y <= side; y++) {
            putFromNeighbour(texels, faces, face, -1, y);
            if (y < 0 || y >= side) {
                for (int x = 0; x < side; x++) {
                    putFromNeighbour(texels, faces, face, x, y);
                }
            } else {
                texels.put(own, 4 * y * side, 4 * side);
            }
            putFromNeighbour(texels, faces, face, side, y);
        }
    }

    private static void putFromNeighbour(ByteBuffer texels, SkyboxLayers faces, int face, int x, int y) {
        int side = faces.side();
        Vector3d point = SkyboxCube.point(face, (2.0 * x + 1) / side - 1, (2.0 * y + 1) / side - 1);
        int neighbour = SkyboxCube.faceOf(point);
        Picture picture = faces.pictures().get(neighbour);
        int nx = texel(SkyboxCube.coordinate(point, neighbour, 1), side);
        int ny = texel(SkyboxCube.coordinate(point, neighbour, 2), side);
        texels.put(picture.samples(), 4 * (ny * side + nx), 4);
    }

    private static int texel(double coordinate, int side) {
        return Math.min(side - 1, Math.max(0, (int) ((coordinate + 1) / 2 * side)));
    }
}
