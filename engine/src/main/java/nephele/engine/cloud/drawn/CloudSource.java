package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import nephele.engine.atmosphere.Air;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.LayerGrid;
import nephele.engine.cloud.cells.LayerGrid.Column;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.field.EllipsoidField;
import nephele.engine.cloud.field.GridField;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.field.ShellField;
import nephele.engine.cloud.field.UniformField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.octave.OctaveSheet;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.appearance.CloudDemand;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A cloud of a level from which cells are sampled at any time. Its space drifts with the cloud: there a layer's pattern
 * stands still or takes another shape, and the eye moves.
 */
public final class CloudSource {
    /** The box in which the mean of a layer is taken, 36 km wide. */
    private static final int MEAN_LEVEL = 2;

    private static final double LAYER_CELL_METRES = 62.5;
    /** Sampled boxes that are kept, in whole clouds. */
    private static final int KEPT = 3;

    /** Columns along each side of the plan of a box. */
    public static final int PLAN_COLUMNS = 512;

    private final Cloud cloud;
    private final LoadedClouds still;
    private final int index;
    private final CloudLight physics;
    private final boolean isShell;
    private final Aabb bounds;
    /** The cells of a finite cloud; {@code null} for a layer. */
    private final CellBox cells;
    /** {@code null} for a finite cloud. */
    private final LayerGrid grid;

    /** {@code null} unless it is drawn as octaves of noise. */
    private final OctaveSheet sheet;

    private final boolean isProfiled;
    private final Map<LightKey, LightCells> lit = new LinkedHashMap<>(16, 0.75f, true);
    private final Map<BoxKey, Box> sampled = new LinkedHashMap<>(16, 0.75f, true);

    /** @param column {@code null} for a finite cloud */
    private record BoxKey(int level, Column column, double seconds) {}

    /** What the light in a box depends on. @param density in the box and in all wider ones */
    private record LightKey(List<DensityCells> density, LightCells.Around around) {}

    /**
     * A sampled box.
     *
     * @param plan how deep columns are inside of the cloud's bodies, −1 to 1 as unsigned 16 bits, {@link #PLAN_COLUMNS}
     *     along each side, x fastest; {@code null} unless of noise with a profile
     * @param columns {@code null} unless for a sheet
     */
    public record Box(DensityCells density, short[] plan, SheetColumns columns) {}

    /**
     * @param still the same clouds without wind
     * @param demand tells into how many cells they are divided
     * @param octaves of clouds that are drawn by technique {@code procedural}
     */
    CloudSource(
            Cloud cloud,
            LoadedClouds still,
            int index,
            CloudLight physics,
            CloudDemand demand,
            ProceduralNoise octaves) {
        this.cloud = cloud;
        this.still = still;
        this.index = index;
        this.physics = physics;
        isShell = still.field(index, 0) instanceof ShellField;
        ExtinctionField field = flat(0);
        boolean isFinite = Double.isFinite(field.bounds().maxX());
        cells = isFinite ? cells(field, demand.longest()) : null;
        grid = isFinite ? null : grid(field.bounds(), demand);
        bounds = isFinite ? cells.box() : field.bounds();
        sheet = cloud.technique() == CloudTechnique.PROCEDURAL ? octaveSheet(field, octaves) : null;
        isProfiled = sheet == null && noise(0) != null;
    }

    /** An ellipsoid's cells end outside of it: at its tips, an eye would otherwise meet half a cell's density at once. */
    private static CellBox cells(ExtinctionField field, int longest) {
        CellBox inBounds = CellBox.of(field.bounds(), longest);
        return field instanceof EllipsoidField ? inBounds.padded() : inBounds;
    }

    /** Returns octaves whose mean optical depth is that of the cloud's own density. */
    private OctaveSheet octaveSheet(ExtinctionField field, ProceduralNoise octaves) {
        CellBox box = box(grid == null ? 0 : MEAN_LEVEL, grid == null ? null : new Column(0, 0));
        double depth = DensityCells.of(field, box, finestMetres(), greatestPerMetre(field))
                .meanDepth();
        return OctaveSheet.of(cloud, octaves, bounds.maxY() - bounds.minY(), depth);
    }

    private static LayerGrid grid(Aabb bounds, CloudDemand demand) {
        int rows = demand.rows(bounds.maxY() - bounds.minY());
        return LayerGrid.ofCloud(bounds.minY(), bounds.maxY(), LAYER_CELL_METRES, rows, CloudDemand.LAYER_BOXES);
    }

    public Cloud cloud() {
        return cloud;
    }

    public CloudLight physics() {
        return physics;
    }

    /** Returns false if it has no extinction anywhere. */
    boolean exists() {
        return cloud.extinctionPerMetre() > 0 && !flat(0).isEmpty();
    }

    /** Returns true if its shape changes with time. */
    public boolean evolves() {
        boolean isNoise = sheet != null || cloud.density() instanceof Cloud.Density.Noise;
        return isNoise && cloud.motion().evolutionSeconds() > 0;
    }

    /** Returns the octaves as which it is drawn; {@code null} for another technique. */
    public OctaveSheet sheet() {
        return sheet;
    }

    /** Returns true if its density is noise with a profile, which is computed and not looked up. */
    public boolean isProfiled() {
        return isProfiled;
    }

    /** Returns the fraction of its extinction that its weather gives it at a time, 0 to 1. */
    public double presence(double seconds) {
        return still.presence(index, seconds);
    }

    /** Returns how far the wind has carried it. */
    public Vec3 drift(double seconds) {
        Vec3 drift = cloud.motion().drift(seconds);
        return grid == null ? drift : new Vec3(drift.x(), 0, drift.z());
    }

    /** Returns the bounds of what is drawn of it at time 0; a layer's are infinite in x and z. */
    public Aabb bounds() {
        return bounds;
    }

    /** Returns half the second derivative of a level ray's height over the cloud's base, per metre. */
    public double halfCurvature() {
        return isShell ? 0.5 / Air.PLANET_RADIUS_METRES : 0;
    }

    /** Returns the narrowest box of cells around the origin. */
    public CellBox narrowest() {
        return box(0, grid == null ? null : new Column(0, 0));
    }

    public int levels() {
        return grid == null ? 1 : grid.levels();
    }

    /** Returns the lattice of a layer; {@code null} for a finite cloud. */
    LayerGrid grid() {
        return grid;
    }

    private CellBox box(int level, Column column) {
        return grid == null ? cells : grid.box(level, column);
    }

    /** Returns its extinction in the space that drifts with it when its weather has come wholly. */
    ExtinctionField flat(double seconds) {
        ExtinctionField field = still.field(index, seconds);
        return field instanceof ShellField shell ? shell.flat() : field;
    }

    /** Returns its noise with a profile in the space that drifts with it; {@code null} for another density. */
    public NoiseField noise(double seconds) {
        return flat(seconds) instanceof NoiseField some && some.density() instanceof ProfiledNoise ? some : null;
    }

    /** Samples it at a time, in boxes with these middles. */
    List<Box> sample(List<Column> columns, double seconds) {
        List<Box> boxes = new ArrayList<>();
        for (int level = 0; level < levels(); level++) {
            Box box = sampled(level, grid == null ? null : columns.get(level), evolves() ? seconds : 0);
            boxes.add(new Box(box.density.scaled(presence(seconds)), box.plan, box.columns));
        }
        return boxes;
    }

    private boolean isSheet() {
        return cloud.technique() == CloudTechnique.SKYPLANE;
    }

    private synchronized Box sampled(int level, Column column, double seconds) {
        var key = new BoxKey(level, column, seconds);
        Box box = sampled.get(key);
        if (box == null) {
            box = sample(box(level, column), seconds);
            sampled.put(key, box);
            if (sampled.size() > KEPT * levels()) {
                sampled.remove(sampled.keySet().iterator().next());
            }
        }
        return box;
    }

    private Box sample(CellBox cells, double seconds) {
        if (sheet != null) {
            double perMetre = sheet.greatestDepth() / (bounds.maxY() - bounds.minY());
            var octaves = new OctaveColumns(sheet, seconds, perMetre);
            return new Box(DensityCells.of(octaves, cells, sheet.cellMetres() / 4, perMetre), null, null);
        }
        ExtinctionField field = flat(seconds);
        double greatest = greatestPerMetre(field);
        if (!isProfiled) {
            DensityCells density = DensityCells.of(field, cells, finestMetres(), greatest);
            DensityCells.Columns columns = (depth, x, y, z) -> field.perMetre(x, y, z);
            return new Box(
                    density, null, isSheet() ? SheetColumns.of(columns, cells, density.greatestPerMetre()) : null);
        }
        var noise = (NoiseField) field;
        var columns = new NoiseColumns(noise);
        return new Box(
                DensityCells.of(columns, cells, finestMetres(), greatest),
                plan(noise, cells.box()),
                isSheet() ? SheetColumns.of(columns, cells, greatest) : null);
    }

    private static short[] plan(NoiseField field, Aabb box) {
        var noise = (ProfiledNoise) field.density();
        short[] depths = new short[PLAN_COLUMNS * PLAN_COLUMNS];
        double x = (box.maxX() - box.minX()) / PLAN_COLUMNS;
        double z = (box.maxZ() - box.minZ()) / PLAN_COLUMNS;
        IntStream.range(0, PLAN_COLUMNS).parallel().forEach(row -> {
            for (int column = 0; column < PLAN_COLUMNS; column++) {
                double depth = noise.bodyDepth(
                        box.minX() + (column + 0.5) * x - field.origin().x(),
                        box.minZ() + (row + 0.5) * z - field.origin().z());
                double stored = Math.max(0, Math.min(1, (depth + 1) / 2));
                depths[row * PLAN_COLUMNS + column] = (short) Math.round(65535 * stored);
            }
        });
        return depths;
    }

    /** Returns the size of what must not be missed between two samples. */
    private double finestMetres() {
        return cloud.density() instanceof Cloud.Density.Noise noise
                ? noise.featureMetres() / 3
                : Double.POSITIVE_INFINITY;
    }

    /** Returns the extinction that density 1 stands for: the same in all boxes of a layer, and at all times. */
    private double greatestPerMetre(ExtinctionField field) {
        if (field instanceof GridField some) {
            return some.greatestPerMetre();
        }
        return field instanceof NoiseField || field instanceof UniformField ? cloud.extinctionPerMetre() : 0;
    }

    /**
     * Returns its cells in some light. That of a box is found again only if this box, a wider one, the sun or a cloud that
     * shades it has changed: a cloud that drifts keeps its light, and so do the wider boxes while the narrowest one moves.
     */
    CellStack lit(List<DensityCells> density, LightCells.Around around) {
        List<LightCells> light = new ArrayList<>();
        for (int box = 0; box < density.size(); box++) {
            light.add(light(new LightKey(List.copyOf(density.subList(box, density.size())), around)));
        }
        return grid == null
                ? CellStack.finite(density.get(0), light.get(0), physics)
                : CellStack.layer(
                        density, light, physics, isShell ? Air.PLANET_RADIUS_METRES : Double.POSITIVE_INFINITY);
    }

    /** Finds the light without a lock, so that a frame that needs another box's does not wait for it. */
    private LightCells light(LightKey key) {
        synchronized (lit) {
            LightCells known = lit.get(key);
            if (known != null) {
                return known;
            }
        }
        LightCells light = LightCells.of(key.density, grid != null, physics, key.around);
        synchronized (lit) {
            lit.put(key, light);
            if (lit.size() > KEPT * levels()) {
                lit.remove(lit.keySet().iterator().next());
            }
        }
        return light;
    }

    /** The columns of a noise with a profile, in the places of its field. */
    private static final class NoiseColumns implements DensityCells.Columns {
        private final NoiseField field;
        private final ProfiledNoise noise;

        private NoiseColumns(NoiseField field) {
            this.field = field;
            noise = (ProfiledNoise) field.density();
        }

        @Override
        public double depth(double x, double z) {
            return noise.bodyDepth(x - field.origin().x(), z - field.origin().z());
        }

        @Override
        public double greatestDepth(double x, double z, double halfX, double halfZ) {
            return noise.greatestBodyDepth(
                    x - field.origin().x(), z - field.origin().z(), halfX, halfZ);
        }

        @Override
        public double leastDepth(double fromY, double toY) {
            return noise.leastDepth(
                    fromY - field.origin().y(), toY - field.origin().y());
        }

        @Override
        public double perMetre(double depth, double x, double y, double z) {
            return field.extinctionPerMetre()
                    * noise.at(
                            depth,
                            x - field.origin().x(),
                            y - field.origin().y(),
                            z - field.origin().z());
        }
    }

    /**
     * The columns of octaves of noise at one time, even from base to top. All of them count as cloud, so that there is light
     * wherever the finer noise of a drawn sheet is.
     *
     * @param perMetre extinction of the greatest optical depth
     */
    private record OctaveColumns(OctaveSheet sheet, double seconds, double perMetre) implements DensityCells.Columns {
        @Override
        public double depth(double x, double z) {
            return sheet.at(x, z, seconds);
        }

        @Override
        public double perMetre(double depth, double x, double y, double z) {
            return depth * perMetre;
        }
    }
}
