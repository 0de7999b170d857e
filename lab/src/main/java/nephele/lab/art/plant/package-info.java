/** The files of plants and rocks that ship. */
package nephele.lab.art.plant;
