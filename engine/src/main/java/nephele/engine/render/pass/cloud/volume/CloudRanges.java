package nephele.engine.render.pass.cloud.volume;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.View;

/** The bounds of all clouds, by which shaders decide whether a surface is among them. */
final class CloudRanges {
    /** Further clouds share the last bounds. */
    private static final int MOST = 8;

    private final List<Aabb> bounds;
    private final double halfCurvature;

    /** The uniforms of {@code cloud-ranges.glsl}. */
    record Places(List<Uniforms.Vector3> base, List<Uniforms.Vector3> half, Uniforms.Scalar bend) {
        static Places of(Uniforms uniforms, int clouds) {
            return new Places(
                    named(uniforms, "rangeBase", clouds),
                    named(uniforms, "rangeHalf", clouds),
                    uniforms.scalar("rangeBend"));
        }

        private static List<Uniforms.Vector3> named(Uniforms uniforms, String name, int count) {
            return IntStream.range(0, count)
                    .mapToObj(i -> uniforms.vector3(name + "[" + i + "]"))
                    .toList();
        }
    }

    CloudRanges(List<MarchedCloud> clouds) {
        List<Aabb> all = clouds.stream().map(MarchedCloud::bounds).toList();
        Aabb rest = all.stream().skip(MOST - 1).reduce(Aabb.EMPTY, Aabb::union);
        bounds = all.size() <= MOST
                ? all
                : java.util.stream.Stream.concat(all.stream().limit(MOST - 1), java.util.stream.Stream.of(rest))
                        .toList();
        halfCurvature =
                clouds.stream().mapToDouble(MarchedCloud::halfCurvature).max().orElse(0);
    }

    int count() {
        return bounds.size();
    }

    /** Returns a distance within which an eye sees no cloud. */
    double nearestMetres(Vec3 eye) {
        double nearest = Double.POSITIVE_INFINITY;
        for (Aabb box : bounds) {
            nearest = Math.min(nearest, distance(box, eye));
        }
        return nearest;
    }

    static double distance(Aabb box, Vec3 eye) {
        double x = Math.max(0, Math.max(box.minX() - eye.x(), eye.x() - box.maxX()));
        double y = Math.max(0, Math.max(box.minY() - eye.y(), eye.y() - box.maxY()));
        double z = Math.max(0, Math.max(box.minZ() - eye.z(), eye.z() - box.maxZ()));
        return Math.sqrt(x * x + y * y + z * z);
    }

    void put(Places places, View view) {
        for (int i = 0; i < bounds.size(); i++) {
            Aabb box = bounds.get(i);
            places.base()
                    .get(i)
                    .set(
                            (float) ((box.minX() + box.maxX()) / 2 - view.eyeX()),
                            (float) (box.minY() - view.eyeY()),
                            (float) ((box.minZ() + box.maxZ()) / 2 - view.eyeZ()));
            places.half().get(i).set((float) ((box.maxX() - box.minX()) / 2), (float) (box.maxY() - box.minY()), (float)
                    ((box.maxZ() - box.minZ()) / 2));
        }
        places.bend().set((float) halfCurvature);
    }
}
