package nephele.engine.render.pass.cloud.volume;

import java.util.List;
import nephele.engine.atmosphere.Air;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.DepthBeyond;
import nephele.engine.cloud.cells.StackBuilder;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.field.ShellField;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.pass.cloud.CloudTextures;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;

/** A cloud of the level with its cells on the GPU and the light around it. */
final class MarchedCloud {
    /** Cells along the longest edge of a finite cloud. */
    private static final int CELLS = 96;
    /** Cells of each box of a layer, along x and z, and up. */
    private static final int LAYER_CELLS = 64;

    private static final int LAYER_ROWS = 24;
    private static final int LAYER_BOXES = 4;
    private static final double LAYER_HALF_METRES = 2_000;
    private static final Vec3 NOON = new Vec3(0, 1, 0);

    private final SharedResources shared;
    private final CloudTextures textures;
    private final CellStack cells;
    private final NoiseField noiseField;
    private final Noise noise;
    private final NoiseTextures noiseTextures;
    private Environment followed;
    private Vec3 towardsSun = NOON;
    private Vec3 irradiance = Vec3.ZERO;
    private Vec3 above = Vec3.ZERO;
    private Vec3 below = Vec3.ZERO;

    private MarchedCloud(LoadContext context, CellStack cells, NoiseField noiseField, Noise noise) {
        shared = context.shared();
        this.cells = cells;
        this.noiseField = noiseField;
        this.noise = noise;
        textures = new CloudTextures(context, cells);
        if (noise == Noise.NONE) {
            noiseTextures = null;
        } else {
            noiseTextures = new NoiseTextures(context, (ProfiledNoise) noiseField.density(), cells.levels());
            noiseTextures.uploadPlan(noiseField, cells);
        }
    }

    static MarchedCloud of(LoadContext context, LoadedClouds loaded, int index) {
        Cloud cloud = loaded.clouds().get(index);
        CloudMedium medium = loaded.at(0).get(index);
        boolean isShell = medium.field() instanceof ShellField;
        ExtinctionField field = isShell ? ((ShellField) medium.field()).flat() : medium.field();
        var optics = CloudOptics.of(cloud.albedo(), cloud.phaseG());
        CloudLight physics = context.shared().shareValue(CloudLight.class, optics, () -> new CloudLight(optics));
        Sun sun = context.scene().level().environment().sun();
        Vec3 towards = sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
        NoiseField profiled =
                field instanceof NoiseField noise && noise.density() instanceof ProfiledNoise ? noise : null;
        boolean evolves = cloud.motion().evolutionSeconds() > 0;
        List<DensityCells> density = DensityCells.of(
                field,
                boxes(field.bounds()),
                profiled == null ? null : profiled::greatestPerMetre,
                finestMetres(cloud.density()));
        var light = new StackBuilder.Light(towards, DepthBeyond.NOTHING);
        var cells = new CellStack(
                density,
                StackBuilder.lit(density, physics, light),
                physics,
                isShell ? Air.PLANET_RADIUS_METRES : Double.POSITIVE_INFINITY);
        return new MarchedCloud(
                context, cells, profiled, profiled == null ? Noise.NONE : evolves ? Noise.EVOLVING : Noise.STILL);
    }

    private static double finestMetres(Cloud.Density density) {
        return density instanceof Cloud.Density.Noise noise ? noise.featureMetres() / 3 : Double.POSITIVE_INFINITY;
    }

    private static List<CellBox> boxes(Aabb box) {
        if (Double.isFinite(box.maxX())) {
            return List.of(CellBox.of(box, CELLS));
        }
        double half = LAYER_HALF_METRES;
        var narrowest = new CellBox(
                new Aabb(-half, box.minY(), -half, half, box.maxY(), half), LAYER_CELLS, LAYER_ROWS, LAYER_CELLS);
        return StackBuilder.around(0, 0, narrowest, LAYER_BOXES);
    }

    Noise noise() {
        return noise;
    }

    boolean isEmpty() {
        return cells.isEmpty();
    }

    /** Returns what contains all of it, heights above the ground of the planet. */
    Aabb bounds() {
        return cells.density().get(cells.levels() - 1).cells().box();
    }

    double halfCurvature() {
        return 0.5 / cells.planetRadiusMetres();
    }

    /** Takes the light of the present environment. */
    void follow(Environment now) {
        if (now == followed) {
            return;
        }
        followed = now;
        Sun sun = Daylight.onGround(now);
        towardsSun = sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
        irradiance = sun == null ? Vec3.ZERO : sun.irradiance();
        SkyIrradiance sky = shared.surfaceLight().irradiance(now);
        above = Vec3.of(sky.ambient(0, 1, 0));
        below = Vec3.of(sky.ambient(0, -1, 0));
    }

    void bind(MarchProgram program, View view, double stepCells) {
        textures.bind();
        if (noiseTextures != null) {
            noiseTextures.bind(program.noisePlaces(), noiseField, view);
        }
        var places = program.places();
        CellBox narrowest = cells.narrowest();
        Aabb box = narrowest.box();
        places.cells()
                .set(narrowest.ny(), cells.light().get(0).cells().ny(), cells.levels(), (float) narrowest.shortest());
        places.cloudBase()
                .set((float) ((box.minX() + box.maxX()) / 2 - view.eyeX()), (float) (box.minY() - view.eyeY()), (float)
                        ((box.minZ() + box.maxZ()) / 2 - view.eyeZ()));
        places.cloudHalf().set((float) ((box.maxX() - box.minX()) / 2), (float) (box.maxY() - box.minY()), (float)
                ((box.maxZ() - box.minZ()) / 2));
        CloudOptics optics = cells.physics().optics();
        places.medium()
                .set(
                        (float) (noise == Noise.NONE ? cells.greatestPerMetre() : noiseField.extinctionPerMetre()),
                        (float) optics.depthScale(),
                        (float) optics.albedo(),
                        (float) optics.scaledAlbedo());
        places.phase()
                .set(
                        (float) optics.scaledCosine(),
                        (float) cells.physics().smallAngles().deepest(),
                        (float) halfCurvature());
        places.stepping().set((float) stepCells, 0.5f, (float) view.eyeY());
        set(places.cloudSun(), towardsSun);
        set(places.irradiance(), irradiance);
        set(places.skyAbove(), above);
        set(places.skyBelow(), below);
    }

    private static void set(nephele.engine.render.gl.shader.Uniforms.Vector3 place, Vec3 v) {
        place.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
