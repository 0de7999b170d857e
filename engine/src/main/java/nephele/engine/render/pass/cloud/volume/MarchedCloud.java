package nephele.engine.render.pass.cloud.volume;

import java.util.List;
import nephele.engine.atmosphere.Air;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.cells.DepthBeyond;
import nephele.engine.cloud.cells.StackBuilder;
import nephele.engine.cloud.field.CloudFields;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.pass.cloud.CloudTextures;
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;

/** A cloud of the level with its cells on the GPU and the light around it. */
final class MarchedCloud {
    /** Cells along the longest edge of a finite cloud. */
    private static final int CELLS = 96;
    /** Cells of each box of a layer, along x and z, and up. */
    private static final int LAYER_CELLS = 96;

    private static final int LAYER_ROWS = 24;
    private static final int LAYER_BOXES = 4;
    private static final double LAYER_HALF_METRES = 2_000;
    private static final Vec3 NOON = new Vec3(0, 1, 0);

    private final SharedResources shared;
    private final CloudTextures textures;
    private final CellStack cells;
    private Environment followed;
    private Vec3 towardsSun = NOON;
    private Vec3 irradiance = Vec3.ZERO;
    private Vec3 above = Vec3.ZERO;
    private Vec3 below = Vec3.ZERO;

    private MarchedCloud(LoadContext context, CellStack cells) {
        shared = context.shared();
        this.cells = cells;
        textures = new CloudTextures(context, cells);
    }

    static MarchedCloud of(LoadContext context, Cloud cloud) {
        ExtinctionField field = CloudFields.of(cloud, context.scene().assets());
        Environment environment = context.scene().level().environment();
        var physics = new CloudLight(CloudOptics.of(cloud.albedo(), cloud.phaseG()));
        Sun sun = environment.sun();
        Vec3 towards = sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
        boolean isRound = environment.sky() instanceof Sky.Atmosphere && cloud.extent() instanceof Cloud.Extent.Layer;
        return new MarchedCloud(
                context,
                StackBuilder.stack(
                        field,
                        boxes(field.bounds()),
                        physics,
                        isRound ? Air.PLANET_RADIUS_METRES : Double.POSITIVE_INFINITY,
                        new StackBuilder.Light(towards, DepthBeyond.NOTHING)));
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
                .set((float) cells.greatestPerMetre(), (float) optics.depthScale(), (float) optics.albedo(), (float)
                        optics.scaledAlbedo());
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
