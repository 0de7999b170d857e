package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import nephele.engine.model.file.MeshText;
import nephele.engine.model.file.ModelFiles;
import nephele.engine.model.shape.TorusShape;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The text of a mesh is written and read in the same way in every locale. */
@Isolated
class MeshLocaleTest {
    @ParameterizedTest
    @ValueSource(strings = {"ar-EG", "ar-EG-u-nu-arab", "de-DE", "tr-TR"})
    void theTextOfAMeshIsTheSame(String tag) {
        Mesh mesh = new TorusShape(1e3, 0.1, 9, 13).mesh();
        String text = new String(MeshText.of(mesh), StandardCharsets.US_ASCII);
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.forLanguageTag(tag));
        try {
            assertEquals(text, new String(MeshText.of(mesh), StandardCharsets.US_ASCII));
            assertEquals("-0.33333334", MeshText.number(-1 / 3f));
            assertArrayEquals(
                    mesh.positions(),
                    ModelFiles.read("a.3d", MeshText.of(mesh), name -> null).positions());
        } finally {
            Locale.setDefault(before);
        }
    }
}
