package nephele.lab.bench;

import java.util.List;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;

/** A level drawn by the engine along a camera path. */
public record LevelDrawing(Renderer renderer, List<View> views, RenderTarget picture) implements Drawing {
    @Override
    public int roundLength() {
        return views.size();
    }

    @Override
    public void draw(int frame) {
        renderer.draw(views.get(frame), picture);
    }

    void draw(int frame, StepListener listener) {
        renderer.draw(views.get(frame), picture, listener);
    }

    @Override
    public void close() {
        renderer.close();
        picture.close();
    }
}
