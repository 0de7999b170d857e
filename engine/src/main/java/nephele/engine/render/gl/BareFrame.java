package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.lwjgl.BufferUtils;

/**
 * One frame in hand-written OpenGL: recorded from the engine's calls, then repeated as a flat list of plain calls,
 * without culling or lists to build, and with one draw in place of many ranges. The difference to the engine's cost is
 * the engine's overhead.
 */
public final class BareFrame implements AutoCloseable {
    private final List<Runnable> calls;
    private final List<GlHandle> handles;
    private final DrawState state;
    private final List<String> words;

    private BareFrame(List<Runnable> calls, List<String> words, List<GlHandle> handles, DrawState state) {
        this.calls = calls;
        this.words = words;
        this.handles = handles;
        this.state = state;
    }

    /** Runs {@code engineFrame} once and records it; the engine's objects must outlive the recording. */
    public static BareFrame record(GlContext gl, Runnable engineFrame) {
        Recorder recorder = new Recorder(gl);
        gl.state().assumeNothing();
        gl.state().listen(recorder);
        try {
            engineFrame.run();
        } finally {
            gl.state().listen(null);
        }
        return new BareFrame(
                List.copyOf(recorder.calls), List.copyOf(recorder.words), List.copyOf(recorder.handles), gl.state());
    }

    /** Returns every change of state and every submission of the recorded frame as text, in order. */
    public List<String> words() {
        return words;
    }

    public void draw() {
        for (int i = 0; i < calls.size(); i++) {
            calls.get(i).run();
        }
        state.assumeNothing();
    }

    @Override
    public void close() {
        handles.forEach(GlHandle::close);
    }

    /** Converts each submission into the preceding state changes and one call. */
    private static final class Recorder implements DrawListener {
        private final GlContext gl;
        private final List<Runnable> calls = new ArrayList<>();
        private final List<String> words = new ArrayList<>();
        private final List<GlHandle> handles = new ArrayList<>();
        private BoundState last = BoundState.NOTHING;

        Recorder(GlContext gl) {
            this.gl = gl;
        }

        @Override
        public void cleared(float[] colour) {
            bindAll();
            words.add("clear " + Arrays.toString(colour));
            if (colour == null) {
                calls.add(() -> glClear(GL_DEPTH_BUFFER_BIT));
            } else {
                calls.add(() -> {
                    glClearColor(colour[0], colour[1], colour[2], colour[3]);
                    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
                });
            }
        }

        @Override
        public void drawn(int[] firsts, int[] counts) {
            bindAll();
            words.add("draw " + Arrays.toString(firsts) + " " + Arrays.toString(counts));
            int engineIndices = glGetInteger(GL_ELEMENT_ARRAY_BUFFER_BINDING);
            GlHandle own =
                    new GlHandle(gl, GlKind.BUFFER, "bare twin's indices", glGenBuffers(), id -> glDeleteBuffers(id));
            handles.add(own);
            int total = gather(engineIndices, own.id(), firsts, counts);
            int id = own.id();
            calls.add(() -> {
                glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, id);
                glDrawElements(GL_TRIANGLES, total, GL_UNSIGNED_INT, 0);
                glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, engineIndices);
            });
        }

        @Override
        public void drawnInstanced(int first, int count, int instances) {
            bindAll();
            words.add("draw instanced " + first + " " + count + " " + instances);
            calls.add(() -> glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, 4L * first, instances));
        }

        /** Copies index ranges one after the other into the recording's own buffer. */
        private static int gather(int from, int to, int[] firsts, int[] counts) {
            int total = 0;
            for (int count : counts) {
                total += count;
            }
            glBindBuffer(GL_COPY_READ_BUFFER, from);
            glBindBuffer(GL_COPY_WRITE_BUFFER, to);
            glBufferData(GL_COPY_WRITE_BUFFER, 4L * total, GL_STATIC_DRAW);
            long at = 0;
            for (int i = 0; i < counts.length; i++) {
                glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 4L * firsts[i], at, 4L * counts[i]);
                at += 4L * counts[i];
            }
            return total;
        }

        @Override
        public void uploaded(int buffer, float[] values) {
            FloatBuffer copy =
                    BufferUtils.createFloatBuffer(values.length).put(values).flip();
            words.add("upload " + buffer + " " + Arrays.hashCode(values));
            calls.add(() -> {
                glBindBuffer(GL_ARRAY_BUFFER, buffer);
                glBufferData(GL_ARRAY_BUFFER, copy, GL_STREAM_DRAW);
            });
        }

        @Override
        public void drawnUnindexed(int first, int count) {
            bindAll();
            words.add("draw unindexed " + first + " " + count);
            calls.add(() -> glDrawArrays(GL_TRIANGLES, first, count));
        }

        @Override
        public void drawnLines(int count) {
            bindAll();
            words.add("draw lines " + count);
            calls.add(() -> glDrawArrays(GL_LINES, 0, count));
        }

        @Override
        public void drawnPoints(int count) {
            bindAll();
            words.add("draw points " + count);
            calls.add(() -> glDrawArrays(GL_POINTS, 0, count));
        }

        @Override
        public void drawnFullScreen() {
            bindAll();
            words.add("draw full screen");
            calls.add(() -> glDrawArrays(GL_TRIANGLES, 0, 3));
        }

        @Override
        public void copied(int from, int to, int width, int height, CopiedPlanes copied) {
            bindAll();
            words.add("copy " + copied + " " + from + " " + to + " " + width + " " + height);
            calls.add(() -> RenderTarget.copyPixels(from, to, width, height, copied));
        }

        private void bindAll() {
            BoundState now = BoundState.read();
            now.changesFrom(last, calls, words);
            last = now.after(last);
        }
    }
}
