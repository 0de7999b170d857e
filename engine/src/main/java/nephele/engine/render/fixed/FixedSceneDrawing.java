package nephele.engine.render.fixed;

import java.nio.FloatBuffer;
import java.util.EnumMap;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.render.fixed.ModelOrder.Motion;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.DrawState.Fill;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.engine.xmlscene.XmlScene;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.lwjgl.BufferUtils;

/** Draws an XML scene, with an entity that is flown about in it and a background if there are any. */
public final class FixedSceneDrawing implements AutoCloseable {
    private static final Matrix4dc AT_HOME = new Matrix4d();

    private final GlContext gl;
    private final Part scene;
    private final Part entity;
    private final BackgroundDrawing background;
    private final AxesDrawing axes;
    private final Texture white;
    private final Map<Shading, FixedProgram> programs = new EnumMap<>(Shading.class);
    private final EyeNumbers eye = new EyeNumbers();
    private final Frustum frustum = Frustum.reusable(6);

    /** A scene with its files. */
    public record Source(XmlScene scene, SceneFiles files) {}

    /** What is drawn. @param entity and background {@code null} for none */
    public record Sources(Source scene, Source entity, Picture background) {}

    private FixedSceneDrawing(GlContext gl, Sources sources) {
        this.gl = gl;
        white = PictureTexture.white(gl);
        scene = new Part(gl, sources.scene(), Motion.STAYS, white, null);
        entity = sources.entity() == null ? null : new Part(gl, sources.entity(), Motion.MOVES, white, scene.poses);
        background = sources.background() == null ? null : new BackgroundDrawing(gl, sources.background());
        axes = new AxesDrawing(gl, axisLength(sources.scene().scene().eye().position()));
    }

    /** As long as in the course's own pictures, and across the picture for an eye that is farther away. */
    private static double axisLength(Vec3 eyePosition) {
        return Math.max(100, 5 * eyePosition.toVector().length());
    }

    /** Sends everything to the GPU. */
    public static FixedSceneDrawing load(GlContext gl, Sources sources) {
        return new FixedSceneDrawing(gl, sources);
    }

    /** What a scene's own camera sees. @param aspect width / height */
    public static View view(XmlScene.Eye eye, double aspect) {
        var projection = new Projection(Math.toRadians(eye.fovDegrees()), aspect, eye.near(), eye.far());
        return View.lookAt(eye.position(), eye.lookAt(), eye.up(), projection);
    }

    /**
     * Replaces what is in the target.
     *
     * @param seconds of the scene's clock
     * @param worldFromEntity where the entity is, without scale; not looked at where there is none
     */
    public void draw(View view, double seconds, Matrix4dc worldFromEntity, SceneLook look, RenderTarget target) {
        eye.set(view);
        scene.pose(seconds, AT_HOME);
        if (entity != null) {
            entity.pose(seconds, worldFromEntity);
        }
        gl.state().fill(Fill.WHOLE);
        target.clear(0, 0, 0);
        if (background != null) {
            background.draw();
        }
        if (look.axes() == SceneLook.Axes.SHOWN) {
            axes.draw(eye);
        }
        drawModels(view, look);
    }

    private void drawModels(View view, SceneLook look) {
        gl.state().fill(look.shading() == Shading.WIREFRAME ? Fill.EDGES : Fill.WHOLE);
        var inputs = programs.computeIfAbsent(look.shading(), shading -> new FixedProgram(gl, shading))
                .use(eye, look);
        boolean culls = look.culling() == SceneLook.Culling.SPHERES;
        frustum.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        frustum.keepAll(eye.exactClipFromRelative());
        scene.draw(inputs, culls ? frustum : null);
        if (entity != null) {
            entity.draw(inputs, culls ? frustum : null);
        }
        gl.state().fill(Fill.WHOLE);
    }

    @Override
    public void close() {
        scene.close();
        if (entity != null) {
            entity.close();
        }
        if (background != null) {
            background.close();
        }
        axes.close();
        white.close();
        programs.values().forEach(FixedProgram::close);
    }

    /** One scene's models with the lights that reach them. */
    private static final class Part implements AutoCloseable {
        private final ScenePoses poses;
        private final ScenePoses lightsAround;
        private final PlacedModels models;
        private final LightTable lights;
        private final BufferTexture lightTexels;
        private final FloatBuffer staging;

        Part(GlContext gl, Source source, Motion least, Texture white, ScenePoses lightsAround) {
            poses = new ScenePoses(source.scene());
            this.lightsAround = lightsAround;
            models = new PlacedModels(gl, ModelOrder.of(poses, source.files(), least), white);
            lights = new LightTable(Math.max(1, poses.lights().size()));
            lightTexels = BufferTexture.changing(gl, "lights");
            staging = BufferUtils.createFloatBuffer(lights.packed().length);
        }

        void pose(double seconds, Matrix4dc outer) {
            poses.set(seconds);
            models.update(outer);
            for (int i = 0; i < poses.lights().size(); i++) {
                var light = poses.lights().get(i);
                lights.put(i, light.what(), light.group().place(), light.lightBefore());
            }
            lightTexels.upload(staging.clear().put(lights.packed()).flip());
        }

        void draw(FixedProgram.Inputs inputs, Frustum frustum) {
            lightTexels.bind(FixedProgram.LIGHTS_UNIT);
            models.draw(inputs, frustum);
        }

        @Override
        public void close() {
            models.close();
            lightTexels.close();
        }
    }
}
