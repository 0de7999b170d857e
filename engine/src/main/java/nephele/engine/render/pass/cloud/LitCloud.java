package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.CellStack;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;

/** The cells of a cloud on the GPU at the time of the frame, and the light around it: the numbers of {@link CellUniforms}. */
public final class LitCloud {
    private final AmbientLight light;
    private final PlacedCloud placed;
    private final CloudSource cloud;
    private final CloudTextures textures;

    private Environment followed;
    private Around around;
    private DrawnCloud shown;
    private DrawnCloud toCome;
    private double share;
    private double groundShare;

    /**
     * The light around a cloud.
     *
     * @param irradiance of the sun
     * @param above mean radiance of the upper half of the sky; {@code below} of the lower one
     */
    record Around(Vec3 towardsSun, Vec3 irradiance, Vec3 above, Vec3 below) {
        /** Returns the greatest difference: radians of the sun's direction, and shares of all light. */
        double difference(Around other) {
            if (other == this) {
                return 0;
            }
            double turn = Math.atan2(towardsSun.cross(other.towardsSun).length(), towardsSun.dot(other.towardsSun));
            double light = irradiance.length() + above.length() + below.length();
            double changed = irradiance.minus(other.irradiance).length()
                    + above.minus(other.above).length()
                    + below.minus(other.below).length();
            return Math.max(turn, changed / Math.max(1e-12, light));
        }
    }

    public LitCloud(LoadContext context, PlacedCloud placed) {
        light = context.get(AmbientLight.RESOURCE);
        this.placed = placed;
        cloud = placed.source();
        textures = new CloudTextures(context, cloud);
    }

    /** Takes its cells and the light around it at the time of the frame. */
    public void follow(Environment environment, CloudInterval now) {
        shown = now.from().clouds().all().get(placed.index());
        toCome = now.to().clouds().all().get(placed.index());
        share = now.share();
        groundShare = now.groundShare();
        textures.show(shown.cells(), toCome.cells());
        follow(environment);
    }

    private void follow(Environment now) {
        if (now == followed) {
            return;
        }
        followed = now;
        Aabb extent = cloud.bounds();
        Sun sun = Daylight.atHeight(now, (extent.minY() + extent.maxY()) / 2);
        SkyIrradiance sky = light.clearIrradiance(now);
        around = new Around(
                CloudTimeline.towardsSun(now),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                Vec3.of(sky.ambient(0, 1, 0)),
                Vec3.of(sky.ambient(0, -1, 0)));
    }

    /** Returns the light around it at the time of the frame. */
    Around around() {
        return around;
    }

    /** Returns the cloud at the earlier of the two sampled times. */
    public DrawnCloud shown() {
        return shown;
    }

    /** Returns the cloud at the later one. */
    public DrawnCloud toCome() {
        return toCome;
    }

    /** Returns the share of the later one, 0 to 1. */
    public double share() {
        return share;
    }

    /**
     * Binds the textures and sets the numbers of a program in use.
     *
     * @param focus of the boxes of layers
     */
    public void put(CellUniforms uniforms, View view, Vec3 focus) {
        put(uniforms.density(), view, focus);
        set(uniforms.cloudSun(), around.towardsSun);
        if (uniforms.diffuseAxis() != null) {
            Vec3 axis = shown.cells().diffuseAxis(around.towardsSun);
            uniforms.diffuseAxis().set((float) axis.x(), (float) axis.y(), (float) axis.z(), (float)
                    cloud.physics().slopeOfBeam());
        }
        set(uniforms.irradiance(), around.irradiance);
        set(uniforms.skyAbove(), around.above);
        set(uniforms.skyBelow(), around.below.scaled(groundShare));
    }

    /** Does the same for a program that needs no light of the cells. */
    public void put(DensityUniforms uniforms, View view, Vec3 focus) {
        textures.bind();
        putBoxes(uniforms.boxes(), view.eye().minus(placed.drift()), focus.minus(view.eye()));
        CloudOptics optics = cloud.physics().optics();
        DeltaScaling scaled = cloud.physics().medium();
        double greatestPerMetre = placed.presence() * shown.fullPerMetre();
        uniforms.medium().set((float) greatestPerMetre, (float) scaled.depthFactor(), (float) optics.albedo(), (float)
                scaled.albedo());
        if (uniforms.phase() != null) {
            uniforms.phase()
                    .set(
                            (float) scaled.g(),
                            (float) (1 / cloud.physics().smallAngles().deepest()),
                            (float) cloud.halfCurvature(),
                            (float) optics.meanCosine());
        }
    }

    /** Returns the least optical depth from the place where a view begins, the eye or the exit in front of it, to the outside. */
    public double depthAround(View view) {
        Plane exit = view.clip();
        Vec3 begin = exit == null ? view.eye() : exit.nearest(view.eye());
        Vec3 place = begin.minus(placed.drift());
        double before = shown.cells().leastDepth(place);
        double after = share == 0 ? before : toCome.cells().leastDepth(place);
        return placed.presence() * (before + share * (after - before));
    }

    private void putBoxes(BoxUniforms uniforms, Vec3 eye, Vec3 focus) {
        CellStack cells = shown.cells();
        for (int level = 0; level < cells.levels(); level++) {
            uniforms.put(level, cells.density().get(level).cells().box(), eye);
        }
        CellBox narrowest = cells.narrowest();
        Aabb box = narrowest.box();
        uniforms.cells().set(narrowest.ny(), cells.light().get(0).cells().ny(), cells.levels(), (float) share);
        if (cells.isLayer()) {
            uniforms.put(box, eye, focus, cells.reachMetres(), cells.reachMetres());
        } else {
            double halfX = (box.maxX() - box.minX()) / 2;
            uniforms.put(box, eye, box.centre().minus(eye), halfX, (box.maxZ() - box.minZ()) / 2);
        }
    }

    private static void set(Uniforms.Vector3 place, Vec3 v) {
        place.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
