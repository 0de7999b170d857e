package nephele.editor.window.dialog;

import java.util.Locale;
import java.util.Set;

/** Kinds of files that levels name, by the endings of their names. */
enum AssetFamily {
    PICTURE(Set.of("png", "jpg", "jpeg", "tga", "bmp")),
    MODEL(Set.of("3d", "obj", "gltf", "glb")),
    VOLUME(Set.of("vol")),
    /** Raw heights; a terrain's heights may also be a picture. */
    HEIGHTS(Set.of("r16")),
    ANY(Set.of());

    private final Set<String> endings;

    AssetFamily(Set<String> endings) {
        this.endings = endings;
    }

    /** Returns the family of a file; {@link #ANY} if levels name no such files. */
    static AssetFamily of(String file) {
        String ending = file.substring(file.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        for (AssetFamily family : values()) {
            if (family.endings.contains(ending)) {
                return family;
            }
        }
        return ANY;
    }

    /** Returns the family that a component names: by its own name, or else as its value does now. */
    static AssetFamily of(String component, String current) {
        String name = component.toLowerCase(Locale.ROOT);
        if (name.equals("heightmap")) {
            return HEIGHTS;
        }
        boolean isPicture =
                name.endsWith("texture") || name.endsWith("map") || name.equals("sprite") || name.equals("files");
        return isPicture ? PICTURE : of(current);
    }

    /** Returns true if a component of this family can name a file. */
    boolean accepts(String file) {
        AssetFamily own = of(file);
        return own != ANY && (this == ANY || this == own || this == HEIGHTS && own == PICTURE);
    }
}
