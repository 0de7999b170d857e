package nephele.engine.render.frame;

import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LampTable;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;

/**
 * The light of a level for every shader that includes {@code surface-light.glsl}: its defines, uniforms and textures.
 * All of it is static; positions are relative to the {@link #anchor}, so it does not move with the eye.
 */
public final class SurfaceLight implements AutoCloseable {
    private final Level level;
    private final Scene scene;
    private final LightMaps maps;
    private final SunLight sun;
    private final LampLight lamps;
    private final ThingShade thingShade;

    private final Function<String, Picture> pictureOf;
    private SkyIrradiance skyIrradiance;

    SurfaceLight(GlContext gl, Scene scene, LoadContext context, Function<String, Picture> pictureOf) {
        this.pictureOf = pictureOf;
        this.scene = scene;
        level = scene.level();
        maps = context.request().lightMaps();
        sun = new SunLight(context.request(), scene.statics(), anchor());
        lamps = new LampLight(gl, context.request(), scene.statics(), anchor());
        thingShade = new ThingShade(gl, maps);
    }

    /** World position that positions in light shaders are relative to. */
    public Vec3 anchor() {
        return scene.solids().isEmpty() ? Vec3.ZERO : scene.solids().origin();
    }

    /** What the shadows of things need. */
    public ThingShade thingShade() {
        return thingShade;
    }

    /** {@code null} without a sun that casts. */
    public ShadowFrame sunFrame() {
        return sun.frame();
    }

    /** {@code null} without lamps. */
    public LampTable lamps() {
        return lamps.table();
    }

    private boolean hasSkyVisibility() {
        return maps.has(Target.SKY_VISIBILITY);
    }

    /** Whether light differs from point to point of a face. */
    public boolean variesOverFaces() {
        return needsPositions() || hasSkyVisibility();
    }

    /** Whether shaders need to know where on the level they are. */
    public boolean needsPositions() {
        return sun.hasShadow() || lamps.table() != null || thingShade.sun();
    }

    public Defines addTo(Defines defines) {
        return addLights(defines)
                .withIf(needsPositions(), "ANCHOR_POSITION")
                .withIf(hasSkyVisibility(), "SKY_AMBIENT")
                .withIf(hasSkyVisibility(), "SKY_VISIBILITY");
    }

    /** The same for models, whose share of the sky stands in their vertices. */
    public Defines addForModels(Defines defines) {
        return addLights(defines).withIf(needsPositions(), "ANCHOR_POSITION").withIf(hasSkyVisibility(), "SKY_AMBIENT");
    }

    /** The same for what moves: it has no place in the light map, so its share of the sky comes otherwise. */
    public Defines addForThings(Defines defines) {
        return addLights(defines).with("ANCHOR_POSITION").withIf(LightNeeds.skyShines(level), "SKY_AMBIENT");
    }

    private Defines addLights(Defines defines) {
        return lamps.addTo(sun.addTo(thingShade.addTo(defines)))
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT");
    }

    /** Sets what a program compiled with {@link #addTo} needs, once and for all. */
    public void set(Uniforms uniforms) {
        setLights(uniforms);
        if (hasSkyVisibility()) {
            uniforms.sampler("skyVisibilityMap", TextureUnit.SKY_VISIBILITY);
            LightUniforms.setSky(uniforms, skyIrradiance());
        }
    }

    /** Sets what a program compiled with {@link #addForModels} needs, once and for all. */
    public void setForModels(Uniforms uniforms) {
        setLights(uniforms);
        if (hasSkyVisibility()) {
            LightUniforms.setSky(uniforms, skyIrradiance());
        }
    }

    /** Sets what a program compiled with {@link #addForThings} needs, once and for all. */
    public void setForThings(Uniforms uniforms) {
        setLights(uniforms);
        if (LightNeeds.skyShines(level)) {
            LightUniforms.setSky(uniforms, skyIrradiance());
        }
    }

    private void setLights(Uniforms uniforms) {
        thingShade.set(uniforms);
        sun.set(uniforms);
        lamps.set(uniforms);
        if (level.environment().ambient() != null) {
            LightUniforms.setAmbient(uniforms, level.environment().ambient());
        }
    }

    private SkyIrradiance skyIrradiance() {
        if (skyIrradiance == null) {
            skyIrradiance = SkyRadiance.of(level.environment().sky(), pictureOf, Decoding.SRGB)
                    .map(SkyIrradiance::of)
                    .orElseGet(SkyIrradiance::black);
        }
        return skyIrradiance;
    }

    /**
     * Binds what a program needs that was made with {@link #addTo}, {@link #addForModels} or {@link #addForThings}.
     *
     * @param reads of {@link LightMaps}, as the pass declares them
     */
    public void bind(SharedResources shared, TargetReads reads) {
        reads.bind(shared);
        lamps.bind();
        thingShade.bind();
    }

    @Override
    public void close() {
        thingShade.close();
        lamps.close();
    }
}
