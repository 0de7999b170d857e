package nephele.engine.render.pass.particle;

import java.util.List;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Emitter;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.particle.LevelParticles;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.AmbientLight;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.RendererClouds;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.SkyIrradiance;
import nephele.engine.scene.probe.SkyProbes;
import org.joml.Vector3d;

/**
 * The light on the particles of each emitter, the same for all of them: mean radiance of the sky as far as it is seen,
 * or the constant ambient light, baked light of surfaces, sun and lamps as scattered evenly in all directions by a thick billow.
 */
final class ParticleLight {
    /** Radiance for an irradiance of 1: twice that of light scattered once, 1 / (4 π). */
    private static final double OF_IRRADIANCE = 1 / (2 * Math.PI);

    /** Radiance for the irradiance of lit clouds, the bolt's own light included. */
    private static final double FLASH_FRACTION = 2 / Math.PI;

    /** The ratio of the lit side of a billow to its middle under sunlight alone, less 1. */
    private static final double RELIEF = 0.7;

    private final Level level;
    private final LevelParticles particles;
    private final RendererClouds clouds;
    /** {@code null} under a constant light from all sides. */
    private final AmbientLight light;

    private final double[] skyFraction;
    /** The light of lamps, and of the surfaces around where light was baked. */
    private final Vector3d[] ofLamps;

    /** Scattered radiance by emitter, RGB. */
    private final float[] radiance;

    private final float[] relief;

    /** {@code null} without lightning. */
    private final FrameLightning lightning;

    /** Radiance that a flash scatters from particles, by emitter, RGB. */
    private final float[] ofFlash;

    private Vec3 towardsSun = Vec3.ZERO;
    private Environment followed;
    /** {@code null} without clouds. */
    private CloudInterval.Sample cloudsFollowed;

    ParticleLight(LoadContext context, LevelParticles particles) {
        level = context.scene().level();
        this.particles = particles;
        clouds = context.get(RendererClouds.RESOURCE);
        light = level.environment().ambient() == null ? context.get(AmbientLight.RESOURCE) : null;
        List<Emitter> emitters = particles.emitters();
        skyFraction = new double[emitters.size()];
        ofLamps = new Vector3d[emitters.size()];
        radiance = new float[3 * emitters.size()];
        relief = new float[3 * emitters.size()];
        ofFlash = new float[3 * emitters.size()];
        lightning = context.get(FrameLightning.RESOURCE);
        for (int i = 0; i < emitters.size(); i++) {
            skyFraction[i] = particles.skyFraction(i);
            ofLamps[i] = ofLamps(emitters.get(i));
            if (LightRequirements.bounces(context.scene().light())) {
                ofLamps[i].add(bounced(
                        context.get(AmbientLight.PROBES), emitters.get(i).centre()));
            }
        }
    }

    private Vector3d ofLamps(Emitter emitter) {
        Vector3d sum = new Vector3d();
        level.lights().stream()
                .flatMap(light -> PunctualLight.of(light).stream())
                .forEach(light -> sum.add(light.irradianceAt(emitter.centre())));
        return sum.mul(OF_IRRADIANCE / 2);
    }

    /** Returns the mean radiance of the static geometry around a place. */
    private static Vector3d bounced(SkyProbes probes, Vec3 place) {
        float[] values = new float[SkyProbes.LIT_VALUES];
        probes.at(place.x(), place.y(), place.z(), values, 0);
        Vector3d sum = new Vector3d();
        for (int at = SkyProbes.VALUES; at < values.length; at += 3) {
            sum.add(values[at], values[at + 1], values[at + 2]);
        }
        return sum.div(SkyProbes.VALUES);
    }

    /** Updates the light to an environment, if it is another one. */
    void follow(Environment now) {
        if (lightning != null) {
            followFlash();
        }
        CloudInterval interval = clouds.current().now();
        CloudInterval.Sample sample = interval == null ? null : interval.from();
        if (now == followed && sample == cloudsFollowed) {
            return;
        }
        followed = now;
        cloudsFollowed = sample;
        Sun sun = Daylight.onGround(now);
        towardsSun = sun == null ? Vec3.ZERO : Directions.unit(sun.directionTowardsSun());
        SkyIrradiance sky = now.ambient() == null ? light.irradiance(now) : null;
        for (int i = 0; i < skyFraction.length; i++) {
            Vector3d around = sky == null ? now.ambient().toVector() : mean(sky).mul(skyFraction[i]);
            Vector3d direct = new Vector3d();
            if (sun != null && sees(sun, i)) {
                direct.set(sun.irradiance().toVector()).mul(OF_IRRADIANCE * cloudFraction(i));
            }
            put(
                    i,
                    around.add(ofLamps[i]),
                    direct,
                    sky == null ? new Vector3d() : skew(sky).mul(skyFraction[i]));
        }
    }

    private void followFlash() {
        for (int i = 0; i < skyFraction.length; i++) {
            Vec3 glow = lightning.isLit()
                    ? lightning.glow(particles.emitters().get(i).centre())
                    : Vec3.ZERO;
            double fraction = FLASH_FRACTION * skyFraction[i];
            ofFlash[3 * i] = (float) (fraction * glow.x());
            ofFlash[3 * i + 1] = (float) (fraction * glow.y());
            ofFlash[3 * i + 2] = (float) (fraction * glow.z());
        }
    }

    /** Returns the share of the sun's light that clouds leave. */
    private double cloudFraction(int emitter) {
        return cloudsFollowed == null
                ? 1
                : cloudsFollowed.sun().from(particles.emitters().get(emitter).centre());
    }

    private static Vector3d mean(SkyIrradiance sky) {
        double[] terms = sky.coefficients();
        return new Vector3d(terms[0], terms[1], terms[2]);
    }

    /** Returns the sum over red, green and blue of the part of the light in proportion to x, y and z of a normal. */
    private static Vector3d skew(SkyIrradiance sky) {
        double[] terms = sky.coefficients();
        return new Vector3d(
                terms[9] + terms[10] + terms[11], terms[3] + terms[4] + terms[5], terms[6] + terms[7] + terms[8]);
    }

    private boolean sees(Sun sun, int emitter) {
        return !sun.castsShadow() || particles.sees(emitter, towardsSun);
    }

    /** Adds up light from all sides and from the sun, and finds from where more of it comes. */
    private void put(int emitter, Vector3d around, Vector3d direct, Vector3d skewed) {
        double sum = around.x + around.y + around.z + direct.x + direct.y + direct.z;
        double ofSun = sum > 0 ? RELIEF * (direct.x + direct.y + direct.z) / sum : 0;
        double ofSky = sum > 0 ? 1 / sum : 0;
        relief[3 * emitter] = (float) (ofSun * towardsSun.x() + ofSky * skewed.x);
        relief[3 * emitter + 1] = (float) (ofSun * towardsSun.y() + ofSky * skewed.y);
        relief[3 * emitter + 2] = (float) (ofSun * towardsSun.z() + ofSky * skewed.z);
        around.add(direct);
        radiance[3 * emitter] = (float) around.x;
        radiance[3 * emitter + 1] = (float) around.y;
        radiance[3 * emitter + 2] = (float) around.z;
    }

    /** Returns the light on particles of an emitter, in one of red, green and blue. */
    float radiance(int emitter, int channel) {
        return radiance[3 * emitter + channel] + ofFlash[3 * emitter + channel];
    }

    /**
     * Returns a component of the direction from which most light comes; its length is by how much the side that faces it
     * is brighter than the middle of a billow, as a share. Zero in even light.
     */
    float relief(int emitter, int axis) {
        return relief[3 * emitter + axis];
    }
}
