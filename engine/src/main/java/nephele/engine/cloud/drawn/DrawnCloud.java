package nephele.engine.cloud.drawn;

import java.util.List;
import nephele.engine.atmosphere.Air;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.DepthBeyond;
import nephele.engine.cloud.cells.StackBuilder;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.field.ShellField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * A cloud of a level, sampled for drawing.
 *
 * @param noise its noise with a profile, whose density is computed and not looked up; {@code null} for another density
 */
public record DrawnCloud(Cloud cloud, CellStack cells, NoiseField noise) {
    /** Cells along the longest edge of a finite cloud. */
    private static final int CELLS = 96;
    /** Cells of each box of a layer, along x and z, and up. */
    private static final int LAYER_CELLS = 64;

    private static final int LAYER_ROWS = 24;
    private static final int LAYER_BOXES = 4;
    private static final double LAYER_HALF_METRES = 2_000;

    /**
     * Samples a cloud.
     *
     * @param field of the cloud at some time
     * @param around the middle of a layer's boxes; only its x and z count
     * @param towardsSun unit
     */
    static DrawnCloud of(Cloud cloud, ExtinctionField field, CloudLight physics, Vec3 around, Vec3 towardsSun) {
        boolean isShell = field instanceof ShellField;
        ExtinctionField flat = field instanceof ShellField shell ? shell.flat() : field;
        NoiseField noise = flat instanceof NoiseField some && some.density() instanceof ProfiledNoise ? some : null;
        List<DensityCells> density = DensityCells.of(
                flat,
                boxes(flat.bounds(), around),
                noise == null ? null : noise::greatestPerMetre,
                finestMetres(cloud.density()));
        var cells = new CellStack(
                density,
                lit(density, physics, towardsSun),
                physics,
                isShell ? Air.PLANET_RADIUS_METRES : Double.POSITIVE_INFINITY);
        return new DrawnCloud(cloud, cells, noise);
    }

    private static List<nephele.engine.cloud.cells.LightCells> lit(
            List<DensityCells> density, CloudLight physics, Vec3 towardsSun) {
        return StackBuilder.lit(density, physics, new StackBuilder.Light(towardsSun, DepthBeyond.NOTHING));
    }

    private static List<CellBox> boxes(Aabb box, Vec3 around) {
        if (Double.isFinite(box.maxX())) {
            return List.of(CellBox.of(box, CELLS));
        }
        double half = LAYER_HALF_METRES;
        var narrowest = new CellBox(
                new Aabb(-half, box.minY(), -half, half, box.maxY(), half), LAYER_CELLS, LAYER_ROWS, LAYER_CELLS);
        return StackBuilder.around(around.x(), around.z(), narrowest, LAYER_BOXES);
    }

    /** Returns the size of what must not be missed between two samples. */
    private static double finestMetres(Cloud.Density density) {
        return density instanceof Cloud.Density.Noise noise ? noise.featureMetres() / 3 : Double.POSITIVE_INFINITY;
    }

    /** Returns the cloud in the light of another sun. */
    DrawnCloud lit(Vec3 towardsSun) {
        return new DrawnCloud(cloud, cells.lit(lit(cells.density(), cells.physics(), towardsSun)), noise);
    }

    /** Returns true if its shape changes with time. */
    public boolean evolves() {
        return noise != null && cloud.motion().evolutionSeconds() > 0;
    }

    /** Returns what contains all of it, heights above the ground of the planet. */
    public Aabb bounds() {
        return cells.density().get(cells.levels() - 1).cells().box();
    }

    /** Returns the extinction that density 1 stands for. */
    public double greatestPerMetre() {
        return noise == null ? cells.greatestPerMetre() : noise.extinctionPerMetre();
    }

    /** Returns half the second derivative of a level ray's height over the cloud's base, per metre. */
    public double halfCurvature() {
        return 0.5 / cells.planetRadiusMetres();
    }
}
