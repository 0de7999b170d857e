package nephele.engine.render.pass.shadow;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;

/**
 * Depth pictures in the layers of one texture, and their contents. The renderers of one opened level share them, so an
 * edit redraws only what it changed.
 */
final class DepthLayers implements GlObject {
    private final GlContext gl;
    private final String name;
    private Texture texture;
    private Texture.Extent extent;
    private final List<RenderTarget> targets = new ArrayList<>();
    private final List<Object> drawn = new ArrayList<>();

    DepthLayers(GlContext gl, String name) {
        this.gl = gl;
        this.name = name;
    }

    /** Draws one layer into its target, or the parts of it that differ. */
    @FunctionalInterface
    interface LayerDrawing {
        /** @param before what the target shows; {@code null} for nothing known */
        void draw(int layer, RenderTarget target, Object before);
    }

    /**
     * Returns the texture; redraws each layer whose content differs.
     *
     * @param contents a value for each layer; equal values mean equal pictures
     */
    Texture showing(List<?> contents, Texture.Extent size, LayerDrawing drawing) {
        fit(size);
        for (int layer = 0; layer < size.layers(); layer++) {
            Object content = contents.get(layer);
            if (!content.equals(drawn.get(layer))) {
                Object before = drawn.set(layer, null);
                drawing.draw(layer, targets.get(layer), before);
                drawn.set(layer, content);
            }
        }
        return texture;
    }

    private void fit(Texture.Extent size) {
        if (!size.equals(extent)) {
            close();
            texture = new Texture(gl, name, Texture.Shape.ARRAY, PixelFormat.DEPTH32F, size, Sampling.NEAREST_CLAMP);
            extent = size;
            for (int layer = 0; layer < size.layers(); layer++) {
                targets.add(RenderTarget.depthLayer(gl, name, texture, layer));
                drawn.add(null);
            }
        }
    }

    @Override
    public void close() {
        targets.forEach(RenderTarget::close);
        targets.clear();
        drawn.clear();
        if (texture != null) {
            texture.close();
            texture = null;
            extent = null;
        }
    }
}
