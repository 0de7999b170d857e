package nephele.engine.cloud.cells;

import nephele.engine.math.bvh.SpatialIndex;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** A cloud that shades others. Equal ones shade alike. */
public final class ShadingCloud {
    private final Shape shape;
    private final Vec3 shift;
    private final double weight;

    /** Its cells, and what is found of them once for all clouds that they shade. */
    private static final class Shape {
        private final List<DensityCells> density;
        private final boolean isLayer;
        private final StackDepths depths;
        private Vec3 crossedBy;
        private LayerCrossing crossing;

        private Shape(List<DensityCells> density, boolean isLayer) {
            this.density = List.copyOf(density);
            this.isLayer = isLayer;
            depths = new StackDepths(this.density, isLayer);
        }

        /** Returns {@code null} for a finite cloud and for light that is too flat. */
        private synchronized LayerCrossing crossing(Vec3 light) {
            if (!isLayer || Math.abs(light.y()) < LayerCrossing.LEAST_SINE) {
                return null;
            }
            if (!light.equals(crossedBy)) {
                crossing = new LayerCrossing(density, depths, light);
                crossedBy = light;
            }
            return crossing;
        }
    }

    /** Directions in which other clouds are looked for from a cell. */
    enum Towards {
        SKY,
        GROUND,
        LIGHT,
        SHADE;

        /** @param light unit, towards it */
        Vec3 direction(Vec3 light) {
            return switch (this) {
                case SKY -> new Vec3(0, 1, 0);
                case GROUND -> new Vec3(0, -1, 0);
                case LIGHT -> light;
                case SHADE -> light.negated();
            };
        }

        boolean isUpright() {
            return this == SKY || this == GROUND;
        }
    }

    /**
     * @param density its cells
     * @param isLayer whether they end at no side
     * @param shift from places of the other cloud's cells to those of its own
     * @param weight of its optical depth in the other one's light: clouds with equal τ (1 − g) dim alike
     */
    public ShadingCloud(List<DensityCells> density, boolean isLayer, Vec3 shift, double weight) {
        this(new Shape(density, isLayer), shift, weight);
    }

    private ShadingCloud(Shape shape, Vec3 shift, double weight) {
        this.shape = shape;
        this.shift = shift;
        this.weight = weight;
    }

    /** Returns the same cloud as it shades yet another one. */
    public ShadingCloud on(Vec3 otherShift, double otherWeight) {
        return new ShadingCloud(shape, otherShift, otherWeight);
    }

    /** Returns its bounds among the cells of the cloud that it shades; a layer's are infinite in x and z. */
    Aabb bounds() {
        Aabb box = shape.density.get(0).cells().box();
        double far = Double.POSITIVE_INFINITY;
        Aabb own = shape.isLayer ? new Aabb(-far, box.minY(), -far, far, box.maxY(), far) : box;
        return own.moved(shift.negated());
    }

    /** Returns what finds depths from cells in some light. Not for a thread of a parallel stream. */
    Depths depths(Vec3 light) {
        return new Depths(this, shape.crossing(light), light);
    }

    /** Finds weighted depths. Immutable. */
    static final class Depths {
        private final ShadingCloud of;
        /** {@code null} if every ray is walked. */
        private final LayerCrossing crossing;

        private final Vec3[] directions;
        private final double base;
        private final double top;

        private Depths(ShadingCloud of, LayerCrossing crossing, Vec3 light) {
            this.of = of;
            this.crossing = crossing;
            directions = new Vec3[Towards.values().length];
            for (Towards towards : Towards.values()) {
                directions[towards.ordinal()] = towards.direction(light);
            }
            base = of.shape.density.get(0).cells().box().minY();
            top = of.shape.density.get(0).cells().box().maxY();
        }

        /** Returns the weighted depth from a point of the other cloud. */
        double from(Towards towards, double x, double y, double z, double cellMetres) {
            Vec3 direction = directions[towards.ordinal()];
            double ownX = x + of.shift.x();
            double ownY = y + of.shift.y();
            double ownZ = z + of.shift.z();
            boolean isOutside = direction.y() > 0 ? ownY <= base : ownY >= top;
            if (crossing != null && isOutside) {
                return of.weight
                        * (towards.isUpright()
                                ? crossing.upright(ownX, ownZ, cellMetres)
                                : crossing.slanted(ownX, ownY, ownZ, cellMetres));
            }
            StackDepths depths = of.shape.depths;
            int level = depths.level(ownX, ownZ, cellMetres);
            return of.weight * depths.from(level, ownX, ownY, ownZ, direction.x(), direction.y(), direction.z());
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ShadingCloud cloud
                && shape.density.equals(cloud.shape.density)
                && shape.isLayer == cloud.shape.isLayer
                && shift.equals(cloud.shift)
                && weight == cloud.weight;
    }

    @Override
    public int hashCode() {
        return Objects.hash(shape.density, shift, weight);
    }

    /**
     * Returns the items of an index whose boxes another box meets on an endless path in one direction, in ascending order.
     *
     * @param from where it begins; sides may be infinite
     */
    static int[] ahead(SpatialIndex index, Aabb from, Vec3 direction) {
        int[] found = new int[index.size()];
        int[] count = new int[1];
        index.query((bounds, at) -> meets(from, direction, bounds, at), item -> found[count[0]++] = item);
        int[] met = Arrays.copyOf(found, count[0]);
        Arrays.sort(met);
        return met;
    }

    private static boolean meets(Aabb from, Vec3 direction, double[] bounds, int at) {
        double enter = 0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double least = axis == 0 ? from.minX() : axis == 1 ? from.minY() : from.minZ();
            double most = axis == 0 ? from.maxX() : axis == 1 ? from.maxY() : from.maxZ();
            double min = bounds[at + axis] - most;
            double max = bounds[at + 3 + axis] - least;
            double along = axis == 0 ? direction.x() : axis == 1 ? direction.y() : direction.z();
            if (along == 0) {
                if (min > 0 || max < 0) {
                    return false;
                }
            } else {
                enter = Math.max(enter, (along > 0 ? min : max) / along);
                leave = Math.min(leave, (along > 0 ? max : min) / along);
            }
        }
        return enter <= leave;
    }
}
