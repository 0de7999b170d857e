package nephele.editor.window.dialog;

import java.util.Locale;
import java.util.Set;

/** Kinds of files that levels name, by the endings of their names. */
enum AssetFamily {
    PICTURE(Set.of("png", "jpg", "jpeg", "tga", "bmp")),
    MODEL(Set.of("obj", "gltf", "glb")),
    VOLUME(Set.of("vol")),
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
        boolean isPicture = component.toLowerCase(Locale.ROOT).endsWith("texture");
        return isPicture ? PICTURE : of(current);
    }
}
