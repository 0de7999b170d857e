package nephele.lab.bench;

/** Frames of a round that can be drawn again and again: the engine's, the bare twin's or the calibration's. */
public interface Drawing extends AutoCloseable {
    /** How many frames a round has. */
    int roundLength();

    /** Submits one frame of the round. */
    void draw(int frame);

    /** Draw calls of the last frame. */
    long draws();

    /** Triangles of the last frame. */
    long triangles();

    @Override
    void close();
}
