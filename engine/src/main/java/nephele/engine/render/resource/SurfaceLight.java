package nephele.engine.render.resource;

import nephele.engine.scene.light.SkyProbes;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.LightMaps;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SmoothSky;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.render.frame.Quality.ShadowSampling;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.PunctualLightTable;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;
import org.joml.Vector3d;

/**
 * The light of a level for every shader that includes {@code surface-light.glsl}: its defines, numbers and textures.
 * Positions are relative to the {@link #anchor}, so they do not depend on the eye.
 */
public final class SurfaceLight implements GlObject {
    public static final SharedResource<SurfaceLight> RESOURCE = SharedResource.of("surface light", SurfaceLight::of)
            .following((light, frame) -> light.follow(frame.frameState().environment()));

    /** The sky visibility of what has no place in the light map; {@code null} if no sky shines. */
    public static final SharedResource<SkyProbes> SKY_PROBES = SharedResource.of(
            "sky probes",
            context -> LightRequirements.skyShines(context.scene().level())
                    ? new SkyProbes(context.scene().statics())
                    : null);

    /** Along a side of the cube over which an atmosphere's light, of degree 2, is integrated. */
    private static final int SMOOTH_CELLS = 16;

    private final Level level;
    private final Scene scene;
    private final LoadContext context;
    private final RendererClouds clouds;
    private final LightMaps maps;
    private final ShadowSampling sampling;
    private final LightParts parts;
    private final LightBlock block;
    private final SunLight sun;
    private final PunctualLighting lights;
    private final DynamicShadows dynamicShadows;
    /** {@code null} without lightning. */
    private final FrameLightning flash;

    private Environment followed;
    /** {@code null} before the first frame, and without clouds. */
    private CloudInterval cloudsFollowed;
    /** Whether the last frame was lit by a flash. */
    private boolean wasLit;

    /** The atmosphere's tables; {@code null} for another sky. */
    private AirTables airTables;

    private SurfaceLight(LoadContext context) {
        this.context = context;
        scene = context.scene();
        level = scene.level();
        FrameRequest request = context.request();
        GlContext gl = context.gl();
        maps = request.lightMaps();
        clouds = context.get(RendererClouds.RESOURCE);
        flash = context.get(FrameLightning.RESOURCE);
        block = context.own(new LightBlock(gl, flash != null));
        sampling = request.quality().shadowFilter();
        parts = request.quality().lightParts();
        block.parts(shares(parts));
        sun = new SunLight(request, scene.statics(), anchor());
        lights = new PunctualLighting(gl, request, scene.lights(), anchor());
        dynamicShadows = new DynamicShadows(gl, maps);
    }

    private static SurfaceLight of(LoadContext context) {
        SurfaceLight light = context.own(new SurfaceLight(context));
        light.follow(context.scene().level().environment());
        return light;
    }

    private static Vec3 shares(LightParts shown) {
        return switch (shown) {
            case ALL -> new Vec3(1, 1, 1);
            case AMBIENT -> new Vec3(1, 0, 0);
            case DIFFUSE -> new Vec3(0, 1, 0);
            case SPECULAR -> new Vec3(0, 0, 1);
        };
    }

    /**
     * Updates the numbers to the current environment, if it has changed.
     *
     * @param now has a sun, sky or constant only if the level has
     */
    private void follow(Environment now) {
        CloudInterval interval = clouds.current().now();
        boolean isSame = interval == null
                || cloudsFollowed != null
                        && interval.from() == cloudsFollowed.from()
                        && interval.share() == cloudsFollowed.share();
        if (now == followed && isSame) {
            followFlash();
            return;
        }
        putFlash();
        sun.put(Daylight.onGround(now), block);
        lights.put(block);
        if (now.ambient() != null) {
            block.ambient(now.ambient());
        }
        if (LightRequirements.skyShines(level)
                && (!isSame
                        || followed == null
                        || !SkyOfLevel.of(context, now).equals(SkyOfLevel.of(context, followed)))) {
            block.sky(irradiance(now));
        }
        block.upload();
        followed = now;
        cloudsFollowed = interval;
    }

    private void followFlash() {
        if (flash != null && (wasLit || flash.isLit())) {
            putFlash();
            block.upload();
        }
    }

    private void putFlash() {
        if (flash != null) {
            block.flash(flash, anchor());
            wasLit = flash.isLit();
        }
    }

    /** @param sun {@code null} if the sky does not depend on it */
    private record SkyOfLevel(Same level, Sky sky, Sun sun) {
        static SkyOfLevel of(LoadContext context, Environment now) {
            Sun sun = now.sky() instanceof Sky.Atmosphere ? now.sun() : null;
            return new SkyOfLevel(context.openedLevel(), now.sky(), sun);
        }
    }

    /** Returns the sky's light on surfaces in an environment. */
    public SkyIrradiance irradiance(Environment now) {
        CloudInterval interval = clouds.current().now();
        SkyIrradiance clear = clearIrradiance(now);
        return interval == null ? clear : CloudedIrradiance.of(interval, now, clear);
    }

    /** Returns the light of the sky without clouds. */
    public SkyIrradiance clearIrradiance(Environment now) {
        if (now.sky() instanceof Sky.Atmosphere sky) {
            return now.sun() == null ? SkyIrradiance.black() : irradiance(sky, now.sun());
        }
        return context.shareValue(SkyIrradiance.class, SkyOfLevel.of(context, now), () -> SkyRadiance.of(
                        now, context.get(PictureArrays.DECODED), ColourDecoding.SRGB)
                .map(SkyIrradiance::of)
                .orElseGet(SkyIrradiance::black));
    }

    private SkyIrradiance irradiance(Sky.Atmosphere sky, Sun sun) {
        if (airTables == null || !airTables.air().equals(Daylight.air(sky))) {
            airTables = context.shareValue(AirTables.class, Daylight.air(sky), () -> AirCache.tables(Daylight.air(sky)));
        }
        Vec3 towardsSun = Directions.unit(sun.directionTowardsSun());
        SmoothSky smooth = new SmoothSky(airTables, towardsSun);
        Moonlight moon = Moonlight.of(sky, sun);
        SmoothSky moonlit = new SmoothSky(airTables, moon.towardsMoon());
        Vector3d moonlight = moon.irradiance().toVector();
        Vector3d outside = sun.irradiance().toVector();
        return SkyIrradiance.of(
                (height, x, y, z) -> smooth.radiance(x, y, z)
                        .add(Heavens.nightGlow(sky, towardsSun.y(), y).toVector())
                        .add(moonlit.radiance(x, y, z).mul(moonlight))
                        .mul(outside),
                SMOOTH_CELLS);
    }

    /** Returns the world position that is the origin of positions in light shaders. */
    public Vec3 anchor() {
        boolean isBare = scene.solids().isEmpty() && scene.statics().ground().isEmpty();
        return isBare ? Vec3.ZERO : scene.solids().origin();
    }

    /** Returns the shadows of dynamic objects. */
    public DynamicShadows dynamicShadows() {
        return dynamicShadows;
    }

    /** Returns the direction towards the sun, or towards the moon when that is the level's directional light. */
    public Vec3 towardsSun() {
        return sun.towardsSun();
    }

    /** Returns the map's projection for the current sun; {@code null} without a sun that casts shadows. */
    public ShadowFrame sunFrame() {
        return sun.frame();
    }

    /** Returns {@code null} without punctual lights. */
    public PunctualLightTable lights() {
        return lights.table();
    }

    private boolean hasSkyVisibility() {
        return maps.has(Target.SKY_VISIBILITY);
    }

    /** Returns true if light varies over a face. */
    public boolean variesOverFaces() {
        return needsPositions() || hasSkyVisibility();
    }

    /** Returns true if shaders need positions in the level. */
    public boolean needsPositions() {
        return sun.hasShadow()
                || sun.hasCloudShade()
                || lights.table() != null
                || dynamicShadows.sun()
                || flash != null;
    }

    public Defines addTo(Defines defines) {
        return addForModels(defines).withIf(hasSkyVisibility(), "SKY_VISIBILITY");
    }

    /** Adds the defines for models, whose sky visibility is a vertex attribute. */
    public Defines addForModels(Defines defines) {
        return addLights(defines).withIf(needsPositions(), "ANCHOR_POSITION").withIf(hasSkyVisibility(), "SKY_AMBIENT");
    }

    /**
     * Adds the defines for dynamic objects, which have no place in the light map; their sky visibility comes from
     * probes.
     */
    public Defines addForDynamicObjects(Defines defines) {
        return addLights(defines).with("ANCHOR_POSITION").withIf(LightRequirements.skyShines(level), "SKY_AMBIENT");
    }

    /** Adds the defines for the gun before the eye, on which no dynamic object's shadow falls. */
    public Defines addForGun(Defines defines) {
        return addStaticLights(defines)
                .with("ANCHOR_POSITION")
                .withIf(LightRequirements.skyShines(level), "SKY_AMBIENT");
    }

    private Defines addLights(Defines defines) {
        return addStaticLights(dynamicShadows.addTo(defines));
    }

    private Defines addStaticLights(Defines defines) {
        return lights.addTo(sun.addTo(defines))
                .withIf(flash != null, "FLASH")
                .withIf(parts != LightParts.ALL, "LIGHT_PARTS")
                .withIf(sampling == ShadowSampling.NEAREST, "NEAREST_SHADOW")
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT");
    }

    /** Binds the samplers and blocks of a program compiled with {@link #addTo} to their fixed places. */
    public void tie(Uniforms uniforms) {
        tieForModels(uniforms);
        if (hasSkyVisibility()) {
            uniforms.sampler("skyVisibilityMap", TextureUnit.SKY_VISIBILITY);
        }
    }

    /** Binds samplers and blocks as {@link #tie} does, for {@link #addForModels}. */
    public void tieForModels(Uniforms uniforms) {
        tieLights(uniforms, hasSkyVisibility());
    }

    /** Binds samplers and blocks as {@link #tie} does, for {@link #addForDynamicObjects}. */
    public void tieForDynamicObjects(Uniforms uniforms) {
        tieLights(uniforms, LightRequirements.skyShines(level));
    }

    /** Binds samplers and blocks as {@link #tie} does, for {@link #addForGun}. */
    public void tieForGun(Uniforms uniforms) {
        tieStaticLights(uniforms, LightRequirements.skyShines(level));
    }

    private void tieLights(Uniforms uniforms, boolean ofSky) {
        dynamicShadows.tie(uniforms);
        tieStaticLights(uniforms, ofSky);
    }

    private void tieStaticLights(Uniforms uniforms, boolean ofSky) {
        sun.tie(uniforms);
        lights.tie(uniforms);
    }

    /**
     * Binds the textures of a program compiled with {@link #addTo}, {@link #addForModels} or {@link
     * #addForDynamicObjects}.
     *
     * @param reads those of {@link LightMaps} that the pass declares
     */
    public void bind(TargetReads reads) {
        reads.bind(context.targets());
        block.bind();
        lights.bind();
        dynamicShadows.bind();
    }

    @Override
    public void close() {
        dynamicShadows.close();
        lights.close();
    }
}
