package nephele.engine.render.pass.sky;

import java.util.List;
import nephele.engine.level.BoxFace;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxSquare;
import org.joml.Vector3d;

/** The directions of a skybox's texels. */
final class SkyboxCube {
    private static final List<SkyboxSquare> FACES = SkyboxSquare.of(SkyboxLayout.FACES);

    private SkyboxCube() {}

    /**
     * Returns the point of the cube of half side 1 at picture coordinates s, t in −1…1; beyond ±1 on the adjacent face.
     */
    static Vector3d point(int face, double s, double t) {
        return FACES.get(face).direction(s, t).toVector();
    }

    /** Returns the face that a direction hits. */
    static int faceOf(Vector3d direction) {
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
    static double right(Vector3d direction, int face) {
        return along(direction, FACES.get(face).right())
                / along(direction, FACES.get(face).outward());
    }

    /** Returns the coordinate downwards, in −1…1, of a direction in its face's picture. */
    static double down(Vector3d direction, int face) {
        return along(direction, FACES.get(face).down())
                / along(direction, FACES.get(face).outward());
    }

    private static double along(Vector3d direction, BoxFace axis) {
        return direction.dot(axis.normal().toVector());
    }
}
