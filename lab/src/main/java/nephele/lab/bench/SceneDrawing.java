package nephele.lab.bench;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.BareTwin;
import nephele.engine.render.fixed.FixedSceneDrawing;
import nephele.engine.render.fixed.SceneLook;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.scene.View;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** An XML scene from its own camera, a sixtieth of a second a frame. */
public final class SceneDrawing implements Drawing {
    private static final Matrix4dc AT_HOME = new Matrix4d();

    private final GlContext gl;
    private final FixedSceneDrawing scene;
    private final View view;
    private final RenderTarget picture;
    private final int frames;

    /** Closes scene and picture with itself. */
    public SceneDrawing(GlContext gl, FixedSceneDrawing scene, View view, RenderTarget picture, int frames) {
        this.gl = gl;
        this.scene = scene;
        this.view = view;
        this.picture = picture;
        this.frames = frames;
    }

    @Override
    public int roundLength() {
        return frames;
    }

    @Override
    public void draw(int frame) {
        gl.state().resetCounts();
        scene.draw(view, frame / 60.0, AT_HOME, SceneLook.USUAL, picture);
    }

    /** The same draws by plain OpenGL calls, with models where the last frame left them; this drawing has to stay open as long. */
    public Drawing bareTwin() {
        List<Runnable> engineFrames = new ArrayList<>();
        long[] draws = new long[frames];
        long[] triangles = new long[frames];
        for (int frame = 0; frame < frames; frame++) {
            int number = frame;
            engineFrames.add(() -> draw(number));
            draw(frame);
            draws[frame] = draws();
            triangles[frame] = triangles();
        }
        return new TwinDrawing(new BareTwin(gl, engineFrames), draws, triangles);
    }

    @Override
    public long draws() {
        return gl.state().draws();
    }

    @Override
    public long triangles() {
        return gl.state().triangles();
    }

    @Override
    public void close() {
        scene.close();
        picture.close();
    }
}
