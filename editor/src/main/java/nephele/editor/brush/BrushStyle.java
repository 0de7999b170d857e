package nephele.editor.brush;

import nephele.engine.level.TextureMapping;

/**
 * The properties of a new brush besides its shape.
 *
 * @param material id, or {@code null} for grey
 */
public record BrushStyle(String material, boolean portalable, TextureMapping textureMapping) {
    public static final BrushStyle PLAIN = new BrushStyle(null, false, TextureMapping.WORLD);
}
