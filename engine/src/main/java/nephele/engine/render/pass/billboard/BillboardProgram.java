package nephele.engine.render.pass.billboard;

import java.util.Collections;
import java.util.Set;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import nephele.engine.render.resource.BillboardList;
import nephele.engine.render.resource.BillboardSource.Kind;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.View;

/** The shaders of billboards. */
final class BillboardProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/billboard/";

    /** The defines of what varies over a billboard and is interpolated between vertices. */
    private static final Set<String> VARYING = Set.of("SUN SKY_AMBIENT FLASH FOG AIR".split(" "));

    private record Numbers(
            Uniforms.Vector3 eyeHigh,
            Uniforms.Vector3 eyeLow,
            @IfRead Uniforms.Vector3 observer,
            Uniforms.Whole perSheet,
            Uniforms.Whole verticesEach) {}

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
        MeteredExposure.readInViews(context);
        Defines lit = light.addForDynamicObjects(Defines.of(context));
        varies = !Collections.disjoint(lit.values().keySet(), VARYING);
        var defines = lit.with("LAMBERT")
                .withIf(kind == Kind.BLENDED, "BLENDED")
                .withIf(isAnimated, "ANIMATED")
                .withIf(fades, "SURFACES")
                .withIf(isObserved, "OBSERVER")
                .values();
        program = GlProgram.of(
                context.gl(), FOLDER + "billboard.vert", FOLDER + "billboard.frag", defines, Numbers.class);
    }

    /** Returns true if the light at the vertices of a billboard, or the air before them, can differ. */
    boolean varies() {
        return varies;
    }

    /** Prepares for the images of a list. */
    void follow(BillboardList list) {
        program.uniforms().perSheet().set(list.perSheet());
        program.uniforms().verticesEach().set(list.vertices());
    }

    /** @param observer {@code null} if billboards face the eye */
    void use(View view, ObserverSphere observer) {
        program.use();
        SolidMesh.eyeInCell(view, anchor, eye);
        program.uniforms().eyeHigh().set(eye[0], eye[1], eye[2]);
        program.uniforms().eyeLow().set(eye[3], eye[4], eye[5]);
        if (observer != null) {
            program.uniforms().observer().set(observer.centre().minus(anchor));
        }
    }
}
