package nephele.engine.render.pass.cloud.skybox;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.DoubleStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;

/**
 * The pictures in which a cloud is seen from a point: the faces of a cube that it can be on, or one narrower picture of a
 * small or distant cloud. A picture is wider than its face by a texel at each side, so that bilinear filtering needs no
 * other face.
 *
 * @param eye the point
 * @param axes of the cube
 * @param layers of the faces along +x, −x, +y, −y, +z and −z of the axes; {@link #NONE} for those without the cloud
 * @param texelsOfFace along 90°
 * @param width of a picture, texels
 */
record BakedFaces(Vec3 eye, Basis axes, List<Integer> layers, int texelsOfFace, int width, int height) {
    static final int NONE = -1;
    private static final int FACES = 6;
    /** Texels beyond a face at both sides. */
    private static final int BORDER = 2;
    /** Widths of narrow pictures are multiples of this, so that a drifting cloud rarely needs another one. */
    private static final int ROUNDING = 32;

    private static final double NEAR_METRES = 1;

    /** @param bounds of the cloud; infinite along x and z for a layer */
    static BakedFaces of(Vec3 eye, Aabb bounds, int texelsOfFace) {
        if (bounds.contains(eye.x(), eye.y(), eye.z())) {
            return cube(eye, Basis.WORLD, texelsOfFace, face -> true);
        }
        if (bounds.maxX() == Double.POSITIVE_INFINITY) {
            int away = bounds.minY() > eye.y() ? 3 : 2;
            return cube(eye, Basis.WORLD, texelsOfFace, face -> face != away);
        }
        Basis axes = Basis.lookAt(eye, bounds.centre(), new Vec3(0, 1, 0), Basis.WORLD);
        List<Vec3> corners = corners(bounds).stream()
                .map(corner -> corner.minus(eye))
                .map(c -> new Vec3(
                        axes.right().dot(c), axes.up().dot(c), axes.back().dot(c)))
                .toList();
        double halfWidth = greatest(corners.stream().mapToDouble(c -> tangent(c.x(), c.z())));
        double halfHeight = greatest(corners.stream().mapToDouble(c -> tangent(c.y(), c.z())));
        if (Math.max(halfWidth, halfHeight) <= 1) {
            return new BakedFaces(
                    eye,
                    axes,
                    List.of(NONE, NONE, NONE, NONE, NONE, 0),
                    texelsOfFace,
                    narrow(halfWidth, texelsOfFace),
                    narrow(halfHeight, texelsOfFace));
        }
        return cube(eye, axes, texelsOfFace, face -> mayShow(face, corners));
    }

    private static double greatest(DoubleStream tangents) {
        return tangents.max().orElseThrow();
    }

    private static double tangent(double across, double back) {
        return back < 0 ? Math.abs(across) / -back : Double.POSITIVE_INFINITY;
    }

    private static int narrow(double half, int texelsOfFace) {
        int texels = (int) Math.ceil(half * texelsOfFace) + BORDER;
        return (texels + ROUNDING - 1) / ROUNDING * ROUNDING;
    }

    private static BakedFaces cube(Vec3 eye, Basis axes, int texelsOfFace, IntPredicate isSeen) {
        List<Integer> layers = new ArrayList<>();
        int count = 0;
        for (int face = 0; face < FACES; face++) {
            layers.add(isSeen.test(face) ? count++ : NONE);
        }
        int side = texelsOfFace + BORDER;
        return new BakedFaces(eye, axes, List.copyOf(layers), texelsOfFace, side, side);
    }

    private static List<Vec3> corners(Aabb box) {
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(box.corner(i));
        }
        return corners;
    }

    /** Returns false if all corners are beyond one side of a face. */
    private static boolean mayShow(int face, List<Vec3> corners) {
        Basis looking = turned(face, Basis.WORLD);
        Vec3 forward = looking.back().negated();
        return List.of(
                        looking.right(),
                        looking.right().negated(),
                        looking.up(),
                        looking.up().negated())
                .stream()
                .allMatch(side -> corners.stream().anyMatch(c -> c.dot(forward.plus(side)) > 0));
    }

    /** Returns the frame that looks along a face. */
    private static Basis turned(int face, Basis axes) {
        Vec3 axis = face / 2 == 0 ? axes.right() : face / 2 == 1 ? axes.up() : axes.back();
        Vec3 forward = face % 2 == 0 ? axis : axis.negated();
        Vec3 up = face / 2 == 1 ? axes.back() : axes.up();
        return new Basis(forward.cross(up), up, forward.negated());
    }

    /** Returns the number of pictures. */
    int count() {
        return (int) layers.stream().filter(layer -> layer != NONE).count();
    }

    /** Returns half the width of a picture at distance 1. */
    double halfWidth() {
        return (double) width / texelsOfFace;
    }

    double halfHeight() {
        return (double) height / texelsOfFace;
    }

    /** Returns the view of a picture. */
    View view(int layer) {
        Basis looking = turned(layers.indexOf(layer), axes);
        var projection = new Projection(
                2 * StrictMath.atan(halfHeight()), (double) width / height, NEAR_METRES, Double.POSITIVE_INFINITY);
        return new View(eye, looking.right(), looking.up(), looking.back(), projection);
    }
}
