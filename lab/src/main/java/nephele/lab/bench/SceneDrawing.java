package nephele.lab.bench;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.SceneAppearance;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** An XML scene drawn 1/60 s later in each frame. Closing it closes the scene and the picture. */
public record SceneDrawing(
        GlContext gl,
        FixedSceneDrawing scene,
        View view,
        SceneAppearance appearance,
        RenderTarget picture,
        int roundLength)
        implements Drawing {
    private static final Matrix4dc AT_HOME = new Matrix4d();

    @Override
    public void draw(int frame) {
        gl.state().resetCounts();
        scene.draw(view, frame / 60.0, AT_HOME, appearance, picture);
    }

    @Override
    public void close() {
        scene.close();
        picture.close();
    }
}
