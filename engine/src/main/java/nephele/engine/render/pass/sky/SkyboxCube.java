package nephele.engine.render.pass.sky;

import java.nio.ByteBuffer;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.level.BoxFace;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxPictures;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import org.joml.Vector3d;
import org.lwjgl.system.MemoryUtil;

/**
 * The pictures of a skybox as layers of a texture, and the directions of their texels. Each layer has a border of one texel
 * from its neighbours: bilinear samples cross the cube's edges without a seam. A flat texture is used because cube textures
 * cost llvmpipe more.
 */
final class SkyboxCube {
    private static final List<SkyboxSquare> FACES = SkyboxSquare.of(SkyboxLayout.FACES);
    private static final int BYTES = 4;

    private SkyboxCube() {}

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
        Vector3d point = point(face, (2.0 * x + 1) / side - 1, (2.0 * y + 1) / side - 1);
        int neighbour = faceOf(point);
        Picture picture = faces.pictures().get(neighbour);
        int nx = texel(right(point, neighbour), side);
        int ny = texel(down(point, neighbour), side);
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

    /**
     * Returns the point of the cube of half side 1 at picture coordinates s, t in −1…1; beyond ±1 on the adjacent face.
     */
    static Vector3d point(int face, double s, double t) {
        return FACES.get(face).direction(s, t).toVector();
    }

    /** Returns the face that a direction hits. */
    private static int faceOf(Vector3d direction) {
        int best = 0;
        for (int face = 1; face < 6; face++) {
            if (along(direction, FACES.get(face).outward())
                    > along(direction, FACES.get(best).outward())) {
                best = face;
            }
        }
        return best;
    }

    /** Returns the coordinate to the right, in −1…1, of a direction in its face's picture. */
    private static double right(Vector3d direction, int face) {
        return along(direction, FACES.get(face).right())
                / along(direction, FACES.get(face).outward());
    }

    /** Returns the coordinate downwards, in −1…1, of a direction in its face's picture. */
    private static double down(Vector3d direction, int face) {
        return along(direction, FACES.get(face).down())
                / along(direction, FACES.get(face).outward());
    }

    private static double along(Vector3d direction, BoxFace axis) {
        return direction.dot(axis.normal().toVector());
    }
}
