package nephele.engine.render.pass.billboard;

import java.util.Collections;
import java.util.Set;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardSource.Kind;
import nephele.engine.render.frame.FrameUniforms;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.View;

/** The shaders of billboards. */
final class BillboardProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/billboard/";

    /** The defines of what varies over a billboard and is interpolated between vertices. */
    private static final Set<String> VARYING = Set.of("SUN SKY_AMBIENT FLASH FOG AIR".split(" "));

    /** @param observer {@code null} if billboards face the eye */
    private record Numbers(
            Uniforms.Vector3 high,
            Uniforms.Vector3 low,
            Uniforms.Vector3 observer,
            Uniforms.Whole perSheet,
            Uniforms.Whole vertices) {}

    private final GlProgram<Numbers> program;
    private final Vec3 anchor;
    private final boolean varies;
    private final float[] eye = new float[6];

    BillboardProgram(LoadContext context, Kind kind) {
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        anchor = light.anchor();
        boolean isAnimated = context.scene().level().billboards().stream()
                .anyMatch(group -> group.blended() && group.frames() > 1 && group.framesPerSecond() > 0);
        boolean fades = kind == Kind.BLENDED && context.request().fadesAtSurfaces();
        boolean isObserved = context.scene().level().observerStart() != null;
        Defines lit = light.addForDynamicObjects(Defines.of(context));
        varies = !Collections.disjoint(lit.values().keySet(), VARYING);
        var defines = lit.with("LAMBERT")
                .withIf(kind == Kind.BLENDED, "BLENDED")
                .withIf(isAnimated, "ANIMATED")
                .withIf(fades, "SURFACES")
                .withIf(isObserved, "OBSERVER")
                .values();
        program = new GlProgram<>(
                context.gl(),
                ShaderSource.load(FOLDER + "billboard.vert", defines),
                ShaderSource.load(FOLDER + "billboard.frag", defines),
                uniforms -> {
                    MeteredExposure.tieInView(context, uniforms);
                    light.tieForDynamicObjects(uniforms);
                    BillboardQuads.tie(uniforms);
                    if (fades) {
                        uniforms.sampler("viewDepth", TextureUnit.VIEW_DEPTH);
                    }
                    return new Numbers(
                            uniforms.vector3("eyeHigh"),
                            uniforms.vector3("eyeLow"),
                            isObserved ? uniforms.vector3("observer") : null,
                            uniforms.whole("perSheet"),
                            uniforms.whole("verticesEach"));
                });
    }

    /** Returns true if the light at the vertices of a billboard, or the air before them, can differ. */
    boolean varies() {
        return varies;
    }

    /** Prepares for the images of a list. */
    void follow(BillboardList list) {
        program.uniforms().perSheet().set(list.perSheet());
        program.uniforms().vertices().set(list.vertices());
    }

    /** @param observer {@code null} if billboards face the eye */
    void use(View view, ObserverSphere observer) {
        program.use();
        SolidMesh.eyeInCell(view, anchor, eye);
        program.uniforms().high().set(eye[0], eye[1], eye[2]);
        program.uniforms().low().set(eye[3], eye[4], eye[5]);
        if (program.uniforms().observer() != null && observer != null) {
            Vec3 place = observer.centre().minus(anchor);
            program.uniforms().observer().set((float) place.x(), (float) place.y(), (float) place.z());
        }
    }
}
