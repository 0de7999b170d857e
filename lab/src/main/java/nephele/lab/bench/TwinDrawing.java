package nephele.lab.bench;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.BareTwin;
import nephele.engine.render.gl.GlContext;

/** The bare OpenGL twin of a drawing's frames. Its counts are those of the engine's frames, which it replays. */
final class TwinDrawing implements Drawing {
    private final BareTwin twin;
    private final long[] draws;
    private final long[] triangles;
    private int lastFrame;

    private TwinDrawing(BareTwin twin, long[] draws, long[] triangles) {
        this.twin = twin;
        this.draws = draws;
        this.triangles = triangles;
    }

    static TwinDrawing of(Drawing engine, GlContext gl) {
        List<Runnable> frames = new ArrayList<>();
        long[] draws = new long[engine.roundLength()];
        long[] triangles = new long[engine.roundLength()];
        for (int i = 0; i < engine.roundLength(); i++) {
            int frame = i;
            frames.add(() -> engine.draw(frame));
            engine.draw(frame);
            draws[frame] = engine.draws(gl);
            triangles[frame] = engine.triangles(gl);
        }
        return new TwinDrawing(new BareTwin(gl, frames), draws, triangles);
    }

    @Override
    public int roundLength() {
        return draws.length;
    }

    @Override
    public void draw(int frame) {
        lastFrame = frame;
        twin.draw(frame);
    }

    @Override
    public long draws(GlContext gl) {
        return draws[lastFrame];
    }

    @Override
    public long triangles(GlContext gl) {
        return triangles[lastFrame];
    }

    @Override
    public void close() {
        twin.close();
    }
}
