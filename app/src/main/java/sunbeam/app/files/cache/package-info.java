/** Cache folder of surfaces' tables, and the computation of missing ones. */
package sunbeam.app.files.cache;
