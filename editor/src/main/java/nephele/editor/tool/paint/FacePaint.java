package nephele.editor.tool.paint;

import java.util.Objects;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;

/** Gives faces of solids a material; {@code null} is grey. */
public final class FacePaint {
    private FacePaint() {}

    /** Returns the solid with a face of the material; the same object if it has it already. */
    public static Solid face(Solid solid, String face, String material) {
        Solid.Face said = SolidFaces.said(solid, face);
        String now = said.material() == null ? solid.material() : said.material();
        return Objects.equals(now, material) ? solid : with(solid, face, material, said.texture());
    }

    /** Returns the solid with a face of the material and its picture elsewhere. */
    static Solid face(Solid solid, String face, String material, TexturePlacement texture) {
        TexturePlacement placement = TexturePlacement.NONE.equals(texture) ? null : texture;
        boolean isSame = Objects.equals(SolidFaces.said(solid, face).texture(), placement);
        return isSame ? face(solid, face, material) : with(solid, face, material, placement);
    }

    private static Solid with(Solid solid, String face, String material, TexturePlacement texture) {
        boolean isInherited = Objects.equals(solid.material(), material);
        // A face cannot say that it is grey: the solid becomes grey and its other faces say what they were.
        Solid base = material == null && !isInherited ? greyed(solid) : solid;
        return SolidFaces.with(
                base,
                face,
                new Solid.Face(
                        isInherited ? null : material,
                        SolidFaces.said(solid, face).portalable(),
                        texture));
    }

    private static Solid greyed(Solid solid) {
        Solid grey = withMaterial(solid, null);
        for (String name : SolidFaces.names(solid)) {
            Solid.Face said = SolidFaces.said(solid, name);
            String material = said.material() == null ? solid.material() : said.material();
            grey = SolidFaces.with(grey, name, new Solid.Face(material, said.portalable(), said.texture()));
        }
        return grey;
    }

    /** Returns the solid with all of its faces of the material; the same object if they are. */
    static Solid whole(Solid solid, String material) {
        Solid painted = withMaterial(solid, material);
        for (String name : SolidFaces.names(solid)) {
            Solid.Face said = SolidFaces.said(solid, name);
            if (said.material() != null) {
                painted = SolidFaces.with(painted, name, new Solid.Face(null, said.portalable(), said.texture()));
            }
        }
        return painted.equals(solid) ? solid : painted;
    }

    private static Solid withMaterial(Solid solid, String material) {
        RecordKind kind = RecordKind.of((Record) solid);
        return (Solid) kind.with((Record) solid, kind.field("material").orElseThrow(), material);
    }
}
