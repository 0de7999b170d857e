package nephele.lab.trade.subject;

import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.xml.XmlModel;

/** Generated meshes in which the sides of cones have the normals of the scene-engine report. */
record ReportCones(SceneFiles files) implements SceneFiles {
    @Override
    public Mesh mesh(XmlModel model) {
        String[] name = model.file().split("_");
        Mesh mesh = files.mesh(model);
        return name[0].equals("cone")
                ? withReportNormals(mesh, Double.parseDouble(name[1]), Double.parseDouble(name[2]))
                : mesh;
    }

    /**
     * The report's side normal is (r sin a, cos(atan(h / R)), r cos a), with the radius r at the point; it is not of
     * unit length.
     */
    static Mesh withReportNormals(Mesh mesh, double radius, double height) {
        float[] normals = mesh.normals().clone();
        float up = (float) Math.cos(Math.atan(height / radius));
        for (int i = 0; i < normals.length; i += 3) {
            boolean isSide = normals[i + 1] > 0;
            if (isSide) {
                normals[i] = mesh.positions()[i];
                normals[i + 1] = up;
                normals[i + 2] = mesh.positions()[i + 2];
            }
        }
        return new Mesh(mesh.positions(), normals, mesh.textureCoordinates(), mesh.indices());
    }

    @Override
    public Picture picture(XmlModel model) {
        return files.picture(model);
    }
}
