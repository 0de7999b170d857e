package nephele.engine.render.pass.cloud.volume;

import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellCloud;
import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.cells.DepthBeyond;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.field.CloudFields;
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
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;

/** A cloud of the level with its cells on the GPU and the light around it. */
final class MarchedCloud {
    private static final int CELLS = 96;
    private static final Vec3 NOON = new Vec3(0, 1, 0);

    private final SharedResources shared;
    private final CloudTextures textures;
    private final CellCloud cells;
    private Environment followed;
    private Vec3 towardsSun = NOON;
    private Vec3 irradiance = Vec3.ZERO;
    private Vec3 above = Vec3.ZERO;
    private Vec3 below = Vec3.ZERO;

    private MarchedCloud(LoadContext context, CellCloud cells) {
        shared = context.shared();
        this.cells = cells;
        textures = new CloudTextures(context, cells);
    }

    static MarchedCloud of(LoadContext context, Cloud cloud) {
        ExtinctionField field = CloudFields.of(cloud, context.scene().assets());
        Aabb box = field.bounds();
        var density = DensityCells.of(field, CellBox.of(box, CELLS), 1);
        var physics = new CloudLight(CloudOptics.of(cloud.albedo(), cloud.phaseG()));
        Sun sun = context.scene().level().environment().sun();
        Vec3 towards = sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
        var light = LightCells.of(density, 2, physics, towards, DepthBeyond.NOTHING);
        return new MarchedCloud(context, new CellCloud(density, light, physics));
    }

    boolean isEmpty() {
        return cells.density().isEmpty();
    }

    double distance(Vec3 eye) {
        Aabb box = cells.density().cells().box();
        double x = Math.max(0, Math.max(box.minX() - eye.x(), eye.x() - box.maxX()));
        double y = Math.max(0, Math.max(box.minY() - eye.y(), eye.y() - box.maxY()));
        double z = Math.max(0, Math.max(box.minZ() - eye.z(), eye.z() - box.maxZ()));
        return Math.sqrt(x * x + y * y + z * z);
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

    void bind(MarchProgram program, View view) {
        textures.bind();
        var places = program.places();
        CellBox box = cells.density().cells();
        places.boxMin()
                .set(
                        (float) (box.box().minX() - view.eyeX()),
                        (float) (box.box().minY() - view.eyeY()),
                        (float) (box.box().minZ() - view.eyeZ()));
        places.boxSize().set((float) (box.nx() * box.sizeX()), (float) (box.ny() * box.sizeY()), (float)
                (box.nz() * box.sizeZ()));
        CloudOptics optics = cells.physics().optics();
        places.medium()
                .set(
                        (float) cells.density().greatestPerMetre(),
                        (float) optics.depthScale(),
                        (float) optics.albedo(),
                        (float) optics.scaledAlbedo());
        places.phase()
                .set(
                        (float) optics.scaledCosine(),
                        (float) cells.physics().smallAngles().deepest(),
                        0,
                        0);
        double step = box.shortest();
        places.stepping().set((float) step, (float) (DensityCells.FARTHEST * box.shortest()), 0.5f);
        set(places.cloudSun(), towardsSun);
        set(places.irradiance(), irradiance);
        set(places.skyAbove(), above);
        set(places.skyBelow(), below);
    }

    private static void set(nephele.engine.render.gl.shader.Uniforms.Vector3 place, Vec3 v) {
        place.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
