package nephele.mutants;

import static nephele.mutants.Mutant.Area.BLENDING;
import static nephele.mutants.Mutant.Area.CULLING;
import static nephele.mutants.Mutant.Area.DEPTH;
import static nephele.mutants.Mutant.Area.LIGHT;
import static nephele.mutants.Mutant.Area.MODEL;
import static nephele.mutants.Mutant.Area.SHADOW;
import static nephele.mutants.Mutant.Area.SRGB;
import static nephele.mutants.Mutants.ENGINE;
import static nephele.mutants.Mutants.SCENES;
import static nephele.mutants.Mutants.SHADERS;

import java.util.List;

/** Faults in culling, depth, blending, shadow, sRGB and the light of XML scenes. */
final class PictureMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    CULLING,
                    "the far corner decides what is outside",
                    ENGINE + "math/Frustum.java",
                    "double highX = a * (a >= 0 ? maxX : minX);",
                    "double highX = a * (a >= 0 ? minX : maxX);",
                    "FrustumTest"),
            new Mutant(
                    CULLING,
                    "three planes instead of six",
                    ENGINE + "math/Frustum.java",
                    "sign >= -1; sign -= 2",
                    "sign >= 1; sign -= 2",
                    "FrustumTest"),
            new Mutant(
                    CULLING,
                    "a leaf drops the item after a hidden one",
                    ENGINE + "math/bvh/SpatialIndex.java",
                    "from = slot + 1;",
                    "from = slot + 2;",
                    "SpatialIndexTest"),
            new Mutant(
                    CULLING,
                    "the last item of a run is not drawn",
                    ENGINE + "scene/VisibleSet.java",
                    "batch.start(endSlot) - start",
                    "batch.start(endSlot - 1) - start",
                    "MetamorphicGlTest"),
            new Mutant(
                    DEPTH,
                    "nearer surfaces do not hide farther ones",
                    ENGINE + "render/gl/DrawState.java",
                    "glDepthMask(newDepth.depthWritten);",
                    "glDepthMask(false);",
                    "OcclusionGlTest"),
            new Mutant(
                    DEPTH,
                    "what lies on the far plane is dropped",
                    ENGINE + "render/gl/DrawState.java",
                    "LESS_OR_EQUAL(GL_LEQUAL, false, true)",
                    "LESS_OR_EQUAL(GL_LESS, false, true)",
                    "OcclusionGlTest"),
            new Mutant(
                    DEPTH,
                    "the near plane is half as far as said",
                    ENGINE + "scene/Projection.java",
                    "isInfinite() ? -2 * nearMetres :",
                    "isInfinite() ? -nearMetres :",
                    "ProjectionTest"),
            new Mutant(
                    DEPTH,
                    "the sky stands in the middle of the depth range",
                    SHADERS + "pass/sky/sky.vert",
                    "vec4(corner, 1.0, 1.0)",
                    "vec4(corner, 0.999, 1.0)",
                    "OcclusionGlTest"),
            new Mutant(
                    BLENDING,
                    "light is added where it should be covered",
                    ENGINE + "render/gl/DrawState.java",
                    "case OVER -> glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,",
                    "case OVER -> glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE,",
                    "OverlayPassGlTest"),
            new Mutant(
                    BLENDING,
                    "letters replace what lies behind them",
                    ENGINE + "render/pass/overlay/OverlayPass.java",
                    "Blend.OVER",
                    "Blend.REPLACE",
                    "OverlayPassGlTest"),
            new Mutant(
                    BLENDING,
                    "blending is never switched on",
                    ENGINE + "render/gl/DrawState.java",
                    "toggle(GL_BLEND, newBlend != Blend.REPLACE && !areSamplesChosen);",
                    "toggle(GL_BLEND, false);",
                    "OverlayPassGlTest"),
            new Mutant(
                    SHADOW,
                    "lit and shaded are exchanged",
                    SHADERS + "include/shadow-filter.glsl",
                    "float shaded = dot(weight, step(5.0 * halfTexelDepth + 2.0 * slope, nearerBy));",
                    "float shaded = dot(weight, step(nearerBy, vec4(5.0 * halfTexelDepth + 2.0 * slope)));",
                    "ShadowEdgeGlTest"),
            new Mutant(
                    SHADOW,
                    "what lies behind a receiver proves light",
                    SHADERS + "include/shadow-filter.glsl",
                    "step(-rounding, nearerBy) - nearer",
                    "1.0 - nearer",
                    "LightTwinsGlTest"),
            new Mutant(
                    SHADOW,
                    "a face that looks another way than a receiver proves light",
                    SHADERS + "include/shadow-filter.glsl",
                    "dot(weight * isLike, step(-rounding",
                    "dot(weight, step(-rounding",
                    "ShadowEdgesProofGlTest"),
            new Mutant(
                    SHADOW,
                    "shadows lie half a texel aside",
                    SHADERS + "include/shadow-filter.glsl",
                    "return floor(texelPosition - 0.5) + 1.0;",
                    "return floor(texelPosition + 0.5) + 1.0;",
                    "ShadowEdgeGlTest"),
            new Mutant(
                    SHADOW,
                    "opposite sides of a lamp's cube are exchanged",
                    SHADERS + "include/light-shadow.glsl",
                    "(p.z < 0.0 ? 1.0 : 0.0);",
                    "(p.z < 0.0 ? 0.0 : 1.0);",
                    "ShadowEdgeGlTest"),
            new Mutant(
                    SHADOW,
                    "half of the sun shines through what casts shadow",
                    SHADERS + "include/surface-light.glsl",
                    "lit *= sunLitShare(",
                    "lit *= 0.5 + 0.5 * sunLitShare(",
                    "ShadowEdgeGlTest"),
            new Mutant(
                    SRGB,
                    "a power of 2.2 instead of sRGB",
                    SHADERS + "include/tone-mapping.glsl",
                    "1.0 / 2.4",
                    "1.0 / 2.2",
                    "OutputGlTest"),
            new Mutant(
                    SRGB,
                    "the straight part of sRGB reaches too far",
                    SHADERS + "include/tone-mapping.glsl",
                    "vec3(0.0031308)",
                    "vec3(0.031308)",
                    "OutputGlTest"),
            new Mutant(
                    SRGB,
                    "dithering brightens",
                    SHADERS + "include/tone-mapping.glsl",
                    "/ 256.0 - 0.5;",
                    "/ 256.0;",
                    "OutputGlTest"),
            new Mutant(
                    SRGB,
                    "textures are taken as linear",
                    ENGINE + "render/gl/PixelFormat.java",
                    "GL_SRGB8_ALPHA8",
                    "GL_RGBA8",
                    "SurfaceGlTest"),
            new Mutant(
                    CULLING,
                    "mirrored models show their insides",
                    SCENES + "java/nephele/scenes/fixed/ModelOrder.java",
                    "? Cull.FRONT : Cull.BACK",
                    "? Cull.BACK : Cull.BACK",
                    "FixedSceneGlTest"),
            new Mutant(
                    CULLING,
                    "a sheared sphere grows as if its axes were at right angles",
                    ENGINE + "math/SingularValues.java",
                    "sweep < MOST_SWEEPS",
                    "sweep < 0",
                    "SingularValuesTest"),
            new Mutant(
                    LIGHT,
                    "a spot light has no edge",
                    SCENES + "resources/nephele/scenes/fixed/fixed-light.glsl",
                    "along < spot.w ? 0.0 : fixedPower",
                    "fixedPower",
                    "FixedLightGlTest"),
            new Mutant(
                    MODEL,
                    "a sphere's last slice shows the whole picture backwards",
                    ENGINE + "model/shape/SphereShape.java",
                    "(double) i / slices",
                    "(double) (i % slices) / slices",
                    "ShapeSurfaceTest"));

    private PictureMutants() {}
}
