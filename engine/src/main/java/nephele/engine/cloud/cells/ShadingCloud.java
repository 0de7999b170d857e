package nephele.engine.cloud.cells;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

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
            if (isUpright()) {
                return new Vec3(0, this == SKY ? 1 : -1, 0);
            }
            return this == LIGHT ? light : light.negated();
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

    /**
     * Optical depths of a whole layer along upright lines and along those of one light, by where a line meets the layer's base:
     * what lies above or below the layer looks them up and need not walk through it. Immutable.
     */
    static final class LayerCrossing {
        /** Sine of the light's elevation from which on lines are looked up: flatter ones cross too many boxes. */
        static final double LEAST_SINE = 0.05;

        /** Distance after which a walk leaves a box, in its cells, as {@link StackDepths#level} takes widths. */
        private static final double NARROW_CELLS = 0.9 * LayerGrid.WALK;

        private final StackDepths depths;
        private final List<DensityCells> density;
        private final double slantX;
        private final double slantZ;
        /** Metres along the level for each metre of height. */
        private final double slant;
        /** Optical depths along upright lines, an array for each level of boxes, x fastest. */
        private final float[][] upright;

        private final float[][] slanted;
        private final double farthestMetres;

        /** Computes the depths on all processors. @param light unit, towards the light or away from it, not flat */
        LayerCrossing(List<DensityCells> density, StackDepths depths, Vec3 light) {
            this.density = density;
            this.depths = depths;
            Vec3 up = light.y() < 0 ? light.negated() : light;
            slantX = up.x() / up.y();
            slantZ = up.z() / up.y();
            slant = Math.hypot(slantX, slantZ);
            upright = new float[density.size()][];
            slanted = new float[density.size()][];
            for (int level = 0; level < density.size(); level++) {
                upright[level] = columns(level, new Vec3(0, 1, 0));
                slanted[level] = columns(level, up);
            }
            farthestMetres =
                    LayerGrid.WALK * density.get(density.size() - 1).cells().sizeX();
        }

        private float[] columns(int level, Vec3 direction) {
            CellBox cells = density.get(level).cells();
            Aabb box = cells.box();
            float[] columns = new float[cells.nx() * cells.nz()];
            IntStream.range(0, cells.nz()).parallel().forEach(k -> {
                for (int i = 0; i < cells.nx(); i++) {
                    columns[k * cells.nx() + i] = (float) depths.from(
                            level,
                            cells.centreX(i),
                            box.minY(),
                            cells.centreZ(k),
                            direction.x(),
                            direction.y(),
                            direction.z());
                }
            });
            return columns;
        }

        /** Returns the depth along the upright line through a point. @param cellMetres width of cells that are fine enough */
        double upright(double x, double z, double cellMetres) {
            int level = depths.level(x, z, cellMetres);
            return at(upright[level], density.get(level).cells(), x, z);
        }

        /** Returns the depth along the light's line through a point. */
        double slanted(double x, double y, double z, double cellMetres) {
            double rise = density.get(0).cells().box().minY() - y;
            double across = Math.abs(rise) * slant;
            if (across > farthestMetres) {
                return 0;
            }
            double baseX = x + rise * slantX;
            double baseZ = z + rise * slantZ;
            // As a walk has it, which is in wider boxes after some distance.
            int level = depths.level(baseX, baseZ, Math.max(cellMetres, across / NARROW_CELLS));
            return at(slanted[level], density.get(level).cells(), baseX, baseZ);
        }

        private static double at(float[] columns, CellBox cells, double x, double z) {
            double u = clamped((x - cells.box().minX()) / cells.sizeX() - 0.5, cells.nx() - 1);
            double w = clamped((z - cells.box().minZ()) / cells.sizeZ() - 0.5, cells.nz() - 1);
            int i = (int) u;
            int k = (int) w;
            int at = k * cells.nx() + i;
            int right = i + 1 < cells.nx() ? 1 : 0;
            int next = k + 1 < cells.nz() ? cells.nx() : 0;
            double near = columns[at] + (u - i) * (columns[at + right] - columns[at]);
            double far = columns[at + next] + (u - i) * (columns[at + next + right] - columns[at + next]);
            return near + (w - k) * (far - near);
        }

        private static double clamped(double cells, int last) {
            return cells < 0 ? 0 : cells > last ? last : cells;
        }
    }
}
