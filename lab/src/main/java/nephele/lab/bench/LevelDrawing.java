package nephele.lab.bench;

import java.util.List;
import nephele.engine.render.BareTwin;
import nephele.engine.render.Renderer;
import nephele.engine.render.Renderer.StepListener;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;

/** A level drawn by the engine along a camera path. */
public final class LevelDrawing implements Drawing {
    private final Renderer renderer;
    private final List<View> views;
    private final RenderTarget picture;

    public LevelDrawing(Renderer renderer, List<View> views, RenderTarget picture) {
        this.renderer = renderer;
        this.views = List.copyOf(views);
        this.picture = picture;
    }

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

    List<String> stepNames() {
        return renderer.stepNames();
    }

    /** The same frames by plain OpenGL calls, with the same counts of draws and triangles; this drawing has to stay open as long. */
    public Drawing bareTwin(GlContext gl) {
        long[] draws = new long[views.size()];
        long[] triangles = new long[views.size()];
        for (int frame = 0; frame < views.size(); frame++) {
            draw(frame);
            draws[frame] = draws();
            triangles[frame] = triangles();
        }
        return new TwinDrawing(new BareTwin(gl, renderer, views, picture), draws, triangles);
    }

    @Override
    public long draws() {
        return renderer.draws();
    }

    @Override
    public long triangles() {
        return renderer.triangles();
    }

    @Override
    public void close() {
        renderer.close();
        picture.close();
    }
}
