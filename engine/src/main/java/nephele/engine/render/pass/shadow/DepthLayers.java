package nephele.engine.render.pass.shadow;

import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;

/**
 * Depth pictures that are the layers of one texture, and what they show. The renderers of one opened level share them, so
 * an edit draws again only what it changed.
 */
final class DepthLayers implements GlObject {
    private final GlContext gl;
    private final String name;
    private Texture texture;
    private Texture.Extent extent;
    private Object shown;

    DepthLayers(GlContext gl, String name) {
        this.gl = gl;
        this.name = name;
    }

    /** Draws one layer into its target. */
    @FunctionalInterface
    interface LayerDrawing {
        void draw(int layer, RenderTarget target);
    }

    /**
     * The texture, each layer drawn again if they show anything else.
     *
     * @param content a value: where it is equal, so are the pictures
     */
    Texture showing(Object content, Texture.Extent size, LayerDrawing drawing) {
        if (!content.equals(shown)) {
            shown = null;
            fit(size);
            for (int layer = 0; layer < size.layers(); layer++) {
                try (RenderTarget target = RenderTarget.depthLayer(gl, name, texture, layer)) {
                    drawing.draw(layer, target);
                }
            }
            shown = content;
        }
        return texture;
    }

    private void fit(Texture.Extent size) {
        if (!size.equals(extent)) {
            close();
            texture = new Texture(gl, name, Texture.Shape.ARRAY, PixelFormat.DEPTH32F, size, Sampling.NEAREST_CLAMP);
            extent = size;
        }
    }

    @Override
    public void close() {
        if (texture != null) {
            texture.close();
            texture = null;
            extent = null;
        }
    }
}
