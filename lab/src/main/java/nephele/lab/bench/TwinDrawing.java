package nephele.lab.bench;

import nephele.engine.render.BareTwin;

/** The bare OpenGL twin of a level's frames; the counts are the engine's, which it repeats. */
final class TwinDrawing implements Drawing {
    private final BareTwin twin;
    private final long[] draws;
    private final long[] triangles;
    private int lastFrame;

    TwinDrawing(BareTwin twin, long[] draws, long[] triangles) {
        this.twin = twin;
        this.draws = draws;
        this.triangles = triangles;
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
    public long draws() {
        return draws[lastFrame];
    }

    @Override
    public long triangles() {
        return triangles[lastFrame];
    }

    @Override
    public void close() {
        twin.close();
    }
}
