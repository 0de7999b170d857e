package nephele.engine.render.frame;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Brush;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LampTable;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;

/**
 * The light of a level for every shader that includes {@code surface-light.glsl}: its defines, uniforms and textures.
 * All of it is static; positions are relative to the {@link #anchor}, so it does not move with the eye.
 */
public final class SurfaceLight implements AutoCloseable {
    private static final int SUN_SHADOW_UNIT = 2;
    private static final int LAMP_SHADOW_UNIT = 3;
    private static final int SKY_VISIBILITY_UNIT = 4;
    private static final int LAMP_TEXELS_UNIT = 5;
    private static final int LAMP_GRID_UNIT = 6;

    private final Level level;
    private final Scene scene;
    private final boolean sunShadow;
    private final boolean lampShadow;
    private final ShadowFrame sunFrame;
    private final LampTable lamps;
    private final BufferTexture lampTexels;
    private final BufferTexture lampGrid;
    private final ThingShade thingShade;

    private final Function<String, Picture> pictureOf;
    private SkyIrradiance skyIrradiance;

    SurfaceLight(GlContext gl, Scene scene, LoadContext context, Function<String, Picture> pictureOf) {
        this.pictureOf = pictureOf;
        this.scene = scene;
        level = scene.level();
        boolean sunCasts = LightNeeds.sunCasts(level);
        lampShadow = LightNeeds.lampShadow(level);
        boolean hasLamps = LightNeeds.lamps(level);
        List<Brush> brushes =
                sunCasts || hasLamps ? level.solids().stream().map(Brush::of).toList() : List.of();
        sunFrame = sunCasts ? sunFrame(brushes, context.quality()) : null;
        sunShadow = sunFrame != null;
        lamps = hasLamps ? LampTable.of(level.lights(), brushes) : null;
        lampTexels = hasLamps ? BufferTexture.ofFloats(gl, "lamps", lamps.packed(anchor())) : null;
        lampGrid = hasLamps ? lampGrid(gl) : null;
        thingShade = new ThingShade(gl, level, context.figure());
    }

    private BufferTexture lampGrid(GlContext gl) {
        try {
            return BufferTexture.ofIntegers(gl, "lamp grid", lamps.packedGrid());
        } catch (RuntimeException e) {
            lampTexels.close();
            throw e;
        }
    }

    /** Targets that {@link #bind} binds for a level. */
    public static Set<Target> targetsRead(Level level) {
        Set<Target> targets = EnumSet.noneOf(Target.class);
        if (LightNeeds.sunShadow(level)) {
            targets.add(Target.SUN_SHADOW);
        }
        if (LightNeeds.lampShadow(level)) {
            targets.add(Target.LAMP_SHADOW);
        }
        if (LightNeeds.skyVisibility(level)) {
            targets.add(Target.SKY_VISIBILITY);
        }
        if (!level.bodies().isEmpty()
                && LightNeeds.sun(level)
                && level.environment().sun().castsShadow()) {
            targets.add(Target.THING_SUN_SHADOW);
        }
        if (!level.bodies().isEmpty() && LightNeeds.lampShadow(level)) {
            targets.add(Target.THING_LAMP_SHADOW);
        }
        return targets;
    }

    private ShadowFrame sunFrame(List<Brush> brushes, Quality quality) {
        Vec3 towardsSun = level.environment().sun().directionTowardsSun();
        List<Vec3> corners = ShadowCasters.of(brushes, towardsSun).stream()
                .flatMap(brush -> brush.shape().vertices().stream())
                .toList();
        return corners.isEmpty() ? null : ShadowFrame.fit(corners, towardsSun, anchor(), quality.shadowTexels());
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
        return sunFrame;
    }

    /** {@code null} without lamps. */
    public LampTable lamps() {
        return lamps;
    }

    /** Whether light differs from point to point of a face. */
    public boolean variesOverFaces() {
        return needsPositions() || scene.skyVisibility() != null;
    }

    /** Whether shaders need to know where on the level they are. */
    public boolean needsPositions() {
        return sunShadow || lamps != null || thingShade.sun();
    }

    public Defines addTo(Defines defines) {
        return thingShade
                .addTo(defines)
                .withIf(LightNeeds.sun(level), "SUN")
                .withIf(sunShadow, "SUN_SHADOW")
                .withIf(lamps != null, "LAMPS")
                .withIf(lampShadow, "LAMP_SHADOW")
                .withIf(needsPositions(), "ANCHOR_POSITION")
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT")
                .withIf(scene.skyVisibility() != null, "SKY_AMBIENT")
                .withIf(scene.skyVisibility() != null, "SKY_VISIBILITY");
    }

    /** The same for what moves: it has no place in the light map, so its share of the sky comes otherwise. */
    public Defines addForThings(Defines defines) {
        return thingShade
                .addTo(defines)
                .withIf(LightNeeds.sun(level), "SUN")
                .withIf(sunShadow, "SUN_SHADOW")
                .withIf(lamps != null, "LAMPS")
                .withIf(lampShadow, "LAMP_SHADOW")
                .with("ANCHOR_POSITION")
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT")
                .withIf(LightNeeds.skyShines(level), "SKY_AMBIENT");
    }

    /** Sets what a program compiled with {@link #addForThings} needs, once and for all. */
    public void setForThings(Uniforms uniforms) {
        setLights(uniforms);
        if (LightNeeds.skyShines(level)) {
            setSkyCoefficients(uniforms);
        }
    }

    /** Sets what a program compiled with {@link #addTo} needs, once and for all. */
    public void set(Uniforms uniforms) {
        setLights(uniforms);
        if (scene.skyVisibility() != null) {
            uniforms.sampler("skyVisibilityMap", SKY_VISIBILITY_UNIT);
            setSkyCoefficients(uniforms);
        }
    }

    private void setLights(Uniforms uniforms) {
        thingShade.set(uniforms);
        Environment environment = level.environment();
        if (LightNeeds.sun(level)) {
            LightUniforms.setSun(uniforms, environment.sun());
        }
        if (environment.ambient() != null) {
            LightUniforms.setAmbient(uniforms, environment.ambient());
        }
        if (sunShadow) {
            uniforms.sampler("sunShadowMap", SUN_SHADOW_UNIT);
            LightUniforms.setSunShadow(uniforms, sunFrame);
        }
        if (lamps != null) {
            uniforms.sampler("lampTexels", LAMP_TEXELS_UNIT);
            uniforms.sampler("lampGridCells", LAMP_GRID_UNIT);
            LightUniforms.setLampGrid(uniforms, lamps.grid(), anchor());
        }
        if (lampShadow) {
            uniforms.sampler("lampShadowMaps", LAMP_SHADOW_UNIT);
        }
    }

    private void setSkyCoefficients(Uniforms uniforms) {
        LightUniforms.setSky(uniforms, skyIrradiance());
    }

    private SkyIrradiance skyIrradiance() {
        if (skyIrradiance == null) {
            skyIrradiance = SkyRadiance.of(level.environment().sky(), pictureOf, Decoding.SRGB)
                    .map(SkyIrradiance::of)
                    .orElseGet(SkyIrradiance::black);
        }
        return skyIrradiance;
    }

    /** Binds the textures; call before drawing with such a program. */
    public void bind(SharedResources shared) {
        if (sunShadow) {
            shared.texture(Target.SUN_SHADOW).bind(SUN_SHADOW_UNIT);
        }
        if (lampShadow) {
            shared.texture(Target.LAMP_SHADOW).bind(LAMP_SHADOW_UNIT);
        }
        if (scene.skyVisibility() != null) {
            shared.texture(Target.SKY_VISIBILITY).bind(SKY_VISIBILITY_UNIT);
        }
        bindLamps();
        thingShade.bind(shared);
    }

    /** As {@link #bind}, for programs made with {@link #addForThings}. */
    public void bindForThings(SharedResources shared) {
        if (sunShadow) {
            shared.texture(Target.SUN_SHADOW).bind(SUN_SHADOW_UNIT);
        }
        if (lampShadow) {
            shared.texture(Target.LAMP_SHADOW).bind(LAMP_SHADOW_UNIT);
        }
        bindLamps();
        thingShade.bind(shared);
    }

    private void bindLamps() {
        if (lamps != null) {
            lampTexels.bind(LAMP_TEXELS_UNIT);
            lampGrid.bind(LAMP_GRID_UNIT);
        }
    }

    @Override
    public void close() {
        thingShade.close();
        if (lamps != null) {
            lampTexels.close();
            lampGrid.close();
        }
    }
}
