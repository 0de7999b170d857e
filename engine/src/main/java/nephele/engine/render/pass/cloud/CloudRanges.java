package nephele.engine.render.pass.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.View;

/** The bounds of all clouds, by which shaders decide whether a surface is among them. */
final class CloudRanges {
    /** Further clouds share the last bounds. */
    private static final int MOST = 8;

    /** Half the width of a layer, metres. */
    private static final double ENDLESS = 1e9;

    private final List<Aabb> bounds = new ArrayList<>();
    private final int count;
    private final double halfCurvature;

    /** The uniforms of {@code cloud-ranges.glsl}. */
    record Places(List<Uniforms.Vector3> rangeBase, List<Uniforms.Vector3> rangeHalf, Uniforms.Vector2 rangePlanet) {}

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

    /** Sets the bounds of all clouds. */
    void put(Places places, View view) {
        for (int i = 0; i < places.rangeBase.size(); i++) {
            put(places, i, bounds.get(i), view);
        }
        places.rangePlanet.set(halfCurvature, view.eyeY());
    }

    private static void put(Places places, int index, Aabb box, View view) {
        boolean isLayer = box.maxX() == Double.POSITIVE_INFINITY;
        double middleX = isLayer ? 0 : (box.minX() + box.maxX()) / 2 - view.eyeX();
        double middleZ = isLayer ? 0 : (box.minZ() + box.maxZ()) / 2 - view.eyeZ();
        places.rangeBase.get(index).set(middleX, box.minY() - view.eyeY(), middleZ);
        double halfX = isLayer ? ENDLESS : (box.maxX() - box.minX()) / 2;
        double halfZ = isLayer ? ENDLESS : (box.maxZ() - box.minZ()) / 2;
        places.rangeHalf.get(index).set(halfX, box.maxY() - box.minY(), halfZ);
    }
}
