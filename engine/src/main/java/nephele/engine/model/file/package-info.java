/**
 * Readers and writers of mesh files: .3d text meshes, Wavefront OBJ and glTF 2.0. {@link
 * nephele.engine.model.file.ModelFiles} chooses the reader by the file's name. Every reader bounds its memory and names
 * file and place in its errors.
 */
package nephele.engine.model.file;
