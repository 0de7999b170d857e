package nephele.engine.cloud.cells;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import nephele.engine.cloud.cells.ShadingCloud.Towards;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/** All clouds of a time and which of them shade which others, found by a spatial index of their bounds. Immutable. */
public final class ShadingClouds {
    private static final double LEAST_STRAIGHTENED = 1e-3;

    private final List<Cast> all;
    private final Vec3 light;
    private final List<ShadingCloud> shading;
    private final List<Aabb> bounds = new ArrayList<>();
    private final SpatialIndex index;

    /**
     * A cloud.
     *
     * @param isLayer whether its cells end at no side
     * @param drift from places of its cells to those of the world
     * @param straightened 1 − ω g: clouds with equal τ (1 − ω g) dim alike
     */
    public record Cast(List<DensityCells> density, boolean isLayer, Vec3 drift, double straightened) {
        private ShadingCloud shading() {
            return new ShadingCloud(density, isLayer, Vec3.ZERO, 1);
        }
    }

    /** @param light unit, towards it */
    public ShadingClouds(List<Cast> all, Vec3 light) {
        this.all = List.copyOf(all);
        this.light = light;
        shading = all.stream().map(Cast::shading).toList();
        for (int i = 0; i < all.size(); i++) {
            bounds.add(shading.get(i).bounds().moved(all.get(i).drift));
        }
        index = SpatialIndex.of(bounds);
    }

    /** Returns the clouds that shade one: what the light's rays through it and upright ones may meet. */
    public List<ShadingCloud> on(int shaded) {
        var met = new BitSet();
        for (Towards towards : Towards.values()) {
            for (int cloud : ShadingCloud.ahead(index, bounds.get(shaded), towards.direction(light))) {
                met.set(cloud);
            }
        }
        met.clear(shaded);
        Cast own = all.get(shaded);
        return met.stream().mapToObj(other -> on(own, other)).toList();
    }

    private ShadingCloud on(Cast shaded, int other) {
        Cast cast = all.get(other);
        double weight = shaded.straightened > LEAST_STRAIGHTENED ? cast.straightened / shaded.straightened : 1;
        return shading.get(other).on(shaded.drift.minus(cast.drift), weight);
    }
}
