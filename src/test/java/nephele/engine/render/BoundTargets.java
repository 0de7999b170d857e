package nephele.engine.render;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.BareFrame;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;

/** Finds the targets whose textures were bound since {@link #mark}, from OpenGL's own state. */
final class BoundTargets implements AutoCloseable {
    private final GlContext gl;
    private final RenderTarget scratch;
    private final Map<Target, List<Texture>> marks = new EnumMap<>(Target.class);
    private final Map<Target, Set<String>> wordsOfMarks = new EnumMap<>(Target.class);

    BoundTargets(GlContext gl) {
        this.gl = gl;
        scratch = RenderTarget.picture(gl, "scratch", PixelFormat.RGBA8, 1, 1);
        for (Target target : Target.values()) {
            if (target.unit() != null) {
                marks.put(target, List.of(mark(Texture.Shape.FLAT), mark(Texture.Shape.ARRAY)));
                Set<String> before = words();
                mark(target);
                Set<String> after = words();
                after.removeAll(before);
                wordsOfMarks.put(target, after);
            }
        }
    }

    private Texture mark(Texture.Shape shape) {
        Texture.Extent extent = Texture.Extent.flat(1, 1);
        return new Texture(gl, "mark", shape, PixelFormat.RGBA8, extent, Sampling.NEAREST_CLAMP);
    }

    private void mark(Target target) {
        marks.get(target).forEach(texture -> texture.bind(target.unit()));
    }

    /** Binds another texture to each target's unit. */
    void mark() {
        marks.keySet().forEach(this::mark);
    }

    Set<Target> boundSinceMark() {
        Set<String> words = words();
        Set<Target> bound = EnumSet.noneOf(Target.class);
        wordsOfMarks.forEach((target, marked) -> {
            if (!words.containsAll(marked)) {
                bound.add(target);
            }
        });
        return bound;
    }

    private Set<String> words() {
        try (BareFrame frame = BareFrame.record(gl, () -> scratch.clear(0, 0, 0))) {
            return new HashSet<>(frame.words());
        }
    }

    @Override
    public void close() {
        scratch.close();
        marks.values().forEach(textures -> textures.forEach(Texture::close));
    }
}
