package nephele.scenes.fixed;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.math.Frustum;
import nephele.engine.render.gl.DrawState.Fill;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.scenes.xml.XmlScene;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** Draws an XML scene, with an optional movable entity and an optional background. */
public final class FixedSceneDrawing implements AutoCloseable {
    private static final Matrix4dc AT_HOME = new Matrix4d();

    private final GlContext gl;
    private final SceneOnGpu scene;
    private final SceneOnGpu entity;
    private final BackgroundDrawing background;
    private final AxesDrawing axes;
    private final Texture white;
    private final Map<Shading, FixedProgram> programs = new EnumMap<>(Shading.class);
    private final EyeNumbers eye = new EyeNumbers();
    private final Frustum frustum = Frustum.reusable(6);

    /** A scene with its files. */
    public record Source(XmlScene scene, SceneFiles files) {}

    /**
     * The sources of a drawing.
     *
     * @param entity {@code null} for none
     * @param background {@code null} for none
     */
    public record Sources(Source scene, Source entity, Picture background) {}

    private FixedSceneDrawing(GlContext gl, Sources sources) {
        this.gl = gl;
        white = PictureTexture.white(gl);
        scene = SceneOnGpu.atHome(gl, sources.scene(), white);
        entity = sources.entity() == null ? null : SceneOnGpu.entity(gl, sources.entity(), white, scene);
        background = sources.background() == null ? null : new BackgroundDrawing(gl, sources.background());
        axes = new AxesDrawing(gl);
    }

    /** Uploads everything to the GPU. */
    public static FixedSceneDrawing load(GlContext gl, Sources sources) {
        return new FixedSceneDrawing(gl, sources);
    }

    /** Returns the view of a scene's own camera. @param aspect width / height */
    public static View view(XmlScene.Eye eye, double aspect) {
        var projection = new Projection(Math.toRadians(eye.fovDegrees()), aspect, eye.near(), eye.far());
        return View.lookAt(eye.position(), eye.lookAt(), eye.up(), projection);
    }

    /**
     * Replaces the content of the target.
     *
     * @param seconds of the scene's clock
     * @param worldFromEntity pose of the entity, without scale; ignored without an entity
     */
    public void draw(View view, double seconds, Matrix4dc worldFromEntity, SceneAppearance look, RenderTarget target) {
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
        if (look.axes()) {
            axes.draw(eye);
        }
        drawModels(look);
        if (look.axes() && eye.isOnAxis()) {
            axes.drawCross(eye, target);
        }
    }

    private void drawModels(SceneAppearance look) {
        gl.state().fill(look.shading() == Shading.WIREFRAME ? Fill.EDGES : Fill.WHOLE);
        var inputs = programs.computeIfAbsent(look.shading(), shading -> new FixedProgram(gl, shading))
                .use(eye, look);
        // Rounded to float, as in shaders.
        frustum.restart(eye.x(), eye.y(), eye.z());
        if (look.culling() == SceneAppearance.Culling.SPHERES) {
            frustum.keepAll(eye.exactClipFromRelative());
        }
        scene.draw(inputs, frustum);
        if (entity != null) {
            entity.draw(inputs, frustum);
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
    }
}
