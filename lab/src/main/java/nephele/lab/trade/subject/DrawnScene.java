package nephele.lab.trade.subject;

import nephele.engine.measure.LinearPicture;
import nephele.engine.render.fixed.FixedSceneDrawing;
import nephele.engine.render.fixed.SceneFiles;
import nephele.engine.render.fixed.SceneLook;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import nephele.engine.xmlscene.XmlScene;
import org.joml.Matrix4d;

/** An XML scene as it is drawn in one way, with a picture to draw it into. */
record DrawnScene(FixedSceneDrawing drawing, View view, SceneLook look, RenderTarget picture) implements AutoCloseable {
    private static final Matrix4d AT_HOME = new Matrix4d();

    static DrawnScene of(GlContext gl, XmlScene scene, SceneFiles files, SceneLook look, int width, int height) {
        var source = new FixedSceneDrawing.Source(scene, files);
        return new DrawnScene(
                FixedSceneDrawing.load(gl, new FixedSceneDrawing.Sources(source, null, null)),
                FixedSceneDrawing.view(scene.eye(), (double) width / height),
                look,
                RenderTarget.picture(gl, "trade", PixelFormat.RGBA8, width, height));
    }

    void draw() {
        drawing.draw(view, 0, AT_HOME, look, picture);
    }

    /** What a display emits of it. */
    LinearPicture displayed() {
        draw();
        return Compared.DISPLAY.read(null, picture);
    }

    @Override
    public void close() {
        drawing.close();
        picture.close();
    }
}
