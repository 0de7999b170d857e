package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.View;

/** The bounds of all clouds, by which shaders decide whether a surface is among them. */
final class CloudRanges {
    /** Further clouds share the last bounds. */
    private static final int MOST = 8;

    /** Half the width of a layer, metres. */
    private static final float ENDLESS = 1e9f;

    private final List<Aabb> bounds = new ArrayList<>();
    private final int count;
    private final double halfCurvature;

    /** The uniforms of {@code cloud-ranges.glsl}. */
    record Places(List<Uniforms.Vector3> base, List<Uniforms.Vector3> half, Uniforms.Vector2 planet) {
        static Places of(Uniforms uniforms, int clouds) {
            return new Places(
                    named(uniforms, "rangeBase", clouds),
                    named(uniforms, "rangeHalf", clouds),
                    uniforms.vector2("rangePlanet"));
        }

        private static List<Uniforms.Vector3> named(Uniforms uniforms, String name, int count) {
            return IntStream.range(0, count)
                    .mapToObj(i -> uniforms.vector3(name + "[" + i + "]"))
                    .toList();
        }
    }

    CloudRanges(List<PlacedCloud> clouds) {
        count = Math.min(MOST, clouds.size());
        halfCurvature = clouds.stream()
                .mapToDouble(cloud -> cloud.source().halfCurvature())
                .max()
                .orElse(0);
    }

    /** Takes the places of the clouds at the present time. */
    void follow(List<PlacedCloud> clouds) {
        bounds.clear();
        for (PlacedCloud cloud : clouds) {
            if (bounds.size() < MOST) {
                bounds.add(cloud.bounds());
            } else {
                bounds.set(MOST - 1, bounds.get(MOST - 1).union(cloud.bounds()));
            }
        }
    }

    int count() {
        return count;
    }

    void put(Places places, View view) {
        for (int i = 0; i < bounds.size(); i++) {
            Aabb box = bounds.get(i);
            boolean isLayer = box.maxX() == Double.POSITIVE_INFINITY;
            places.base()
                    .get(i)
                    .set(
                            isLayer ? 0 : (float) ((box.minX() + box.maxX()) / 2 - view.eyeX()),
                            (float) (box.minY() - view.eyeY()),
                            isLayer ? 0 : (float) ((box.minZ() + box.maxZ()) / 2 - view.eyeZ()));
            places.half()
                    .get(i)
                    .set(
                            isLayer ? ENDLESS : (float) ((box.maxX() - box.minX()) / 2),
                            (float) (box.maxY() - box.minY()),
                            isLayer ? ENDLESS : (float) ((box.maxZ() - box.minZ()) / 2));
        }
        places.planet().set((float) halfCurvature, (float) view.eyeY());
    }
}
