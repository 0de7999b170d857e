package nephele.engine.render.frame;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.TextureUnit;
import nephele.engine.render.gl.Uniforms;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;

/** The sun's part of {@code surface-light.glsl}, with the shadows of what never moves. */
final class SunLight {
    private final Level level;
    private final ShadowFrame frame;

    /**
     * @param statics of the level
     * @param anchor what positions in shaders are relative to
     */
    SunLight(FrameRequest request, StaticShapes statics, Vec3 anchor) {
        level = request.level();
        boolean casts = request.lightMaps().has(Target.SUN_SHADOW);
        frame = casts ? frame(level.environment().sun(), statics, anchor, request.quality()) : null;
    }

    private static ShadowFrame frame(Sun sun, StaticShapes statics, Vec3 anchor, Quality quality) {
        Vec3 towardsSun = sun.directionTowardsSun();
        List<Vec3> corners = ShadowCasters.corners(statics, towardsSun);
        if (corners.isEmpty()) {
            // The frame plan knows the level only, not that all its meshes are empty.
            corners = List.of(anchor);
        }
        return ShadowFrame.fit(corners, towardsSun, anchor, quality.shadowTexels());
    }

    /** {@code null} without a sun that casts. */
    ShadowFrame frame() {
        return frame;
    }

    boolean hasShadow() {
        return frame != null;
    }

    Defines addTo(Defines defines) {
        return defines.withIf(LightNeeds.sun(level), "SUN").withIf(hasShadow(), "SUN_SHADOW");
    }

    void set(Uniforms uniforms) {
        if (LightNeeds.sun(level)) {
            LightUniforms.setSun(uniforms, level.environment().sun());
        }
        if (hasShadow()) {
            uniforms.sampler("sunShadowMap", TextureUnit.SUN_SHADOW);
            LightUniforms.setSunShadow(uniforms, frame);
        }
    }
}
