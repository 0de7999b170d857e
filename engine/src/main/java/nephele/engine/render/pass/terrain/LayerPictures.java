package nephele.engine.render.pass.terrain;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.scene.SceneMaterials.PictureArray;
import nephele.engine.scene.SceneMaterials.Slot;

/**
 * The pictures of a terrain's layers, which its shader reads from one array.
 *
 * @param array the scene's array if all have its size, {@link #OWN} for {@code own}, −1 without pictures
 * @param own pictures of several sizes
 * @param places the picture of each layer in the array, −1 for none
 */
record LayerPictures(int array, List<Picture> own, List<Integer> places) {
    static final int OWN = Integer.MAX_VALUE;

    /** Makes those of the layers' slots in the scene's arrays. */
    static LayerPictures of(List<Slot> slots, List<PictureArray> arrays) {
        List<Integer> used = slots.stream()
                .map(Slot::array)
                .filter(array -> array >= 0)
                .distinct()
                .toList();
        if (used.size() <= 1) {
            return new LayerPictures(
                    used.isEmpty() ? -1 : used.get(0),
                    List.of(),
                    slots.stream()
                            .map(slot -> slot.array() < 0 ? -1 : slot.layer())
                            .toList());
        }
        List<Picture> own = new ArrayList<>();
        List<Integer> places = new ArrayList<>();
        for (Slot slot : slots) {
            places.add(slot.array() < 0 ? -1 : own.size());
            if (slot.array() >= 0) {
                own.add(arrays.get(slot.array()).layers().get(slot.layer()));
            }
        }
        return new LayerPictures(OWN, own, places);
    }

    /** Returns the picture of a layer as its material says it to the shader. */
    Slot slot(int layer) {
        return new Slot(array, places.get(layer));
    }
}
